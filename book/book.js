// Nothing on a page waits for this; all of it works without. What is folded and meant for paper is unfolded to be
// printed, or when an address points into it; code can be copied; a told number explains itself; ← and → turn the
// page, / leads to the search.
const all = (selector, work) => document.querySelectorAll(selector).forEach(work);
const make = (tag, properties) => Object.assign(document.createElement(tag), properties);

addEventListener('beforeprint', () =>
  all('main details:not([open], .plain)', (d) => {
    d.open = true;
    d.dataset.printed = '';
  }),
);
addEventListener('afterprint', () =>
  all('details[data-printed]', (d) => {
    d.open = false;
    delete d.dataset.printed;
  }),
);

const unfold = () => {
  let id = location.hash.slice(1);
  try {
    id = decodeURIComponent(id);
  } catch {
    // an address may hold a bare %
  }
  const target = document.getElementById(id);
  for (let d = target?.closest('details'); d; d = d.parentElement.closest('details')) d.open = true;
  if (target?.closest('details')) target.scrollIntoView();
};
addEventListener('hashchange', unfold);
unfold();

// The contents show the page that is read.
const here = document.querySelector('.contents-tree [aria-current]');
const tree = here?.closest('.contents-tree');
if (tree && tree.scrollHeight > tree.clientHeight)
  tree.scrollTop = here.offsetTop - tree.offsetTop - tree.clientHeight / 3;

all('main pre.code, main pre.told', (pre) => {
  const button = make('button', { type: 'button', className: 'copy', textContent: 'copy' });
  button.setAttribute('aria-label', 'Copy this code');
  button.addEventListener('click', async () => {
    const text = pre.querySelector('code').cloneNode(true);
    text.querySelectorAll('.prompt, .omitted').forEach((e) => e.remove());
    await navigator.clipboard.writeText(text.textContent.trimEnd());
    button.textContent = 'copied';
    setTimeout(() => {
      button.textContent = 'copy';
    }, 1500);
  });
  const frame = make('div', { className: `copyable ${pre.className}` });
  pre.replaceWith(frame);
  frame.append(pre, button);
});

// What a told number is, and which checks look at it: by pointer, touch or keyboard.
const known = JSON.parse(document.getElementById('numbers')?.textContent ?? '{}');
const card = make('div', { className: 'explains', id: 'explains', hidden: true });
card.setAttribute('role', 'status');
document.body.append(card);
let shown = null;
const hide = () => {
  card.hidden = true;
  shown?.removeAttribute('aria-describedby');
  shown = null;
};
const show = (number) => {
  const it = known[number.dataset.name];
  if (!it) return;
  const line = (className, text) => make('p', { className, textContent: text });
  const proof = line('proof', '');
  if (it.checks?.length) {
    proof.append(it.checks.length > 1 ? 'Looked at by the checks ' : 'Looked at by the check ');
    it.checks.forEach(({ n, words }, i) =>
      proof.append(i ? '; ' : '', make('a', { href: `${it.page}#check-${n}`, textContent: words })),
    );
  } else if (it.illustration) proof.append(`An illustration: ${it.illustration}`);
  card.replaceChildren(
    line('name', number.dataset.name),
    line('value', number.dataset.now ?? it.value),
    line('meaning', it.meaning),
    ...(proof.textContent ? [proof] : []),
  );
  card.hidden = false;
  const at = number.getBoundingClientRect();
  const left = Math.max(8, Math.min(at.left, document.documentElement.clientWidth - card.offsetWidth - 8));
  card.style.left = `${left + scrollX}px`;
  card.style.top = `${at.bottom + scrollY + 6}px`;
  number.setAttribute('aria-describedby', 'explains');
  shown = number;
};
addEventListener('click', (e) => {
  const number = e.target.closest('[data-name]');
  if (number) {
    if (shown === number) hide();
    else show(number);
  } else if (!e.target.closest('.explains')) hide();
});
addEventListener('keydown', (e) => {
  if (e.key === 'Escape') hide();
  if (/^(Enter| )$/.test(e.key) && e.target.matches('data.told')) {
    e.preventDefault();
    e.target.click();
  }
  if (e.ctrlKey || e.metaKey || e.altKey || e.target.matches('input, textarea, select, [contenteditable]')) return;
  const side = e.target.closest('pre, .table, .formula, figure');
  if (side && side.scrollWidth > side.clientWidth) return;
  const to = { ArrowLeft: 'prev', ArrowRight: 'next' }[e.key];
  const link = to && document.querySelector(`link[rel=${to}]`);
  if (link) location.href = link.href;
  if (e.key === '/') {
    e.preventDefault();
    document.querySelector('.find input').focus();
  }
});

// Where the section runs in the page itself: its script comes when a field, a slider, a scene or the checks are first touched, or
// by an address with numbers (#zeta=60). Else only the scenes move, by a script that comes when one is first touched.
const src = document.querySelector('[data-frames]') ? 'scene.js' : 'live/live.js';
const live = [...document.querySelectorAll('.parameters .field, .again, .controls')];
const wake = (event) => {
  if (self.liveListens) return;
  if (event?.type === 'click') self.liveWanted = event.target.closest('button') ?? self.liveWanted;
  if (!self.liveWoken) document.head.append(make('script', { src }));
  self.liveWoken = true;
};
for (const place of live) for (const type of ['focusin', 'pointerover', 'click', 'input']) place.addEventListener(type, wake);
if (live.length && /^#\w+=/.test(location.hash)) wake();

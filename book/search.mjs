// The search, used twice: finish.mjs builds the index with it, and search.html (as search.js) looks up in it.

/**
 * A word as it is indexed: lower case, and what the old prints set alike taken as one: u and v, i and j, æ
 * and ae.
 */
export const folded = (term) => {
  const plain = term
    .toLowerCase()
    .normalize('NFD')
    .replace(/\p{M}/gu, '')
    .replace(/æ/g, 'ae')
    .replace(/œ/g, 'oe')
    .replace(/ſ/g, 's');
  return plain.replace(/v/g, 'u').replace(/j/g, 'i') || null;
};

export const options = { fields: ['title', 'text'], storeFields: ['page', 'title', 'shown', 'text', 'rank'] };

/** The words of a text, folded, between blanks: so that a phrase is a piece of it. */
const phraseOf = (text) => ` ${[...text.matchAll(/[\p{L}\p{N}]+/gu)].map((m) => folded(m[0])).join(' ')} `;

/** What is asked: words, and what stands between quotation marks as it stands. */
export function asked(query) {
  const phrases = [...query.matchAll(/["“„]([^"”“]+)["”“]/g)].map((m) => phraseOf(m[1]));
  return { words: query.replace(/["“”„]/g, ' '), phrases };
}

/** What is found, the book's own pages before the library's. */
export function found(index, query) {
  const { words, phrases } = asked(query);
  return index
    .search(words, {
      prefix: !phrases.length,
      fuzzy: (term) => (term.length > 5 && !phrases.length ? 0.15 : 0),
      combineWith: 'AND',
      boost: { title: 3 },
      boostDocument: (_, __, { rank }) => rank,
    })
    .filter((hit) => phrases.every((p) => phraseOf(`${hit.title} . ${hit.text}`).includes(p)))
    .sort((a, b) => b.rank - a.rank || b.score - a.score);
}

/** The text around the first of the words found, as nodes with the words marked. */
function excerpt(text, terms, phrase) {
  const words = [...text.matchAll(/[\p{L}\p{N}]+/gu)];
  const wanted = phrase?.trim().split(' ') ?? [];
  const at = wanted.length
    ? words.findIndex((_, i) => wanted.every((w, k) => folded(words[i + k]?.[0] ?? '') === w))
    : -1;
  const hits = at < 0 ? words.filter((w) => terms.includes(folded(w[0]))) : words.slice(at, at + wanted.length);
  const start = Math.max((hits[0]?.index ?? 0) - 70, 0);
  const piece = document.createElement('p');
  let from = start;
  for (const hit of hits.filter((h) => h.index < start + 240)) {
    piece.append(
      text.slice(from, hit.index),
      Object.assign(document.createElement('mark'), { textContent: hit[0] }),
    );
    from = hit.index + hit[0].length;
  }
  piece.append(text.slice(from, start + 260), ' …');
  return piece;
}

function load(src) {
  return new Promise((done, failed) => {
    document.head.append(
      Object.assign(document.createElement('script'), { src, onload: done, onerror: failed }),
    );
  });
}

async function look(query) {
  await Promise.all([load('minisearch.js'), load('search-index.js')]);
  const index = window.MiniSearch.loadJS(window.bookIndex, { ...options, processTerm: folded });
  const hits = found(index, query);
  document.getElementById('found').textContent =
    hits.length === 1 ? 'One place' : `${hits.length || 'No'} places`;
  document.getElementById('results').replaceChildren(
    ...hits.slice(0, 50).map((hit) => {
      const item = document.createElement('li');
      item.append(
        Object.assign(document.createElement('a'), { href: hit.page, textContent: hit.shown ?? hit.title }),
        excerpt(hit.text, hit.terms, asked(query).phrases[0]),
      );
      return item;
    }),
  );
}

if (typeof document !== 'undefined') {
  const query = new URLSearchParams(window.location.search).get('q')?.trim();
  document.getElementById('q').value = query ?? '';
  if (query) look(query);
}

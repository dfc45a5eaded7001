// Nothing on a page waits for this. What is folded is unfolded to be printed, or when an address points into
// it.
addEventListener('beforeprint', () =>
  document.querySelectorAll('main details:not([open])').forEach((d) => {
    d.open = true;
    d.dataset.printed = '';
  }),
);
addEventListener('afterprint', () =>
  document.querySelectorAll('details[data-printed]').forEach((d) => {
    d.open = false;
    delete d.dataset.printed;
  }),
);
const unfold = () =>
  document
    .getElementById(decodeURIComponent(location.hash.slice(1)))
    ?.closest('details')
    ?.setAttribute('open', '');
addEventListener('hashchange', unfold);
unfold();

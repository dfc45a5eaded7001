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

export const options = { fields: ['title', 'text'], storeFields: ['page', 'title', 'text'] };

/** The text around the first of the words found, as nodes with the words marked. */
function excerpt(text, terms) {
  const words = [...text.matchAll(/[\p{L}\p{N}]+/gu)];
  const hits = words.filter((w) => terms.includes(folded(w[0])));
  const start = Math.max((hits[0]?.index ?? 0) - 70, 0);
  const piece = document.createElement('p');
  let at = start;
  for (const hit of hits.filter((h) => h.index < start + 240)) {
    piece.append(
      text.slice(at, hit.index),
      Object.assign(document.createElement('mark'), { textContent: hit[0] }),
    );
    at = hit.index + hit[0].length;
  }
  piece.append(text.slice(at, start + 260), ' …');
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
  const found = index.search(query, {
    prefix: true,
    fuzzy: (term) => (term.length > 5 ? 0.15 : 0),
    combineWith: 'AND',
    boost: { title: 3 },
  });
  document.getElementById('found').textContent =
    found.length === 1 ? 'One page' : `${found.length || 'No'} pages`;
  document.getElementById('results').replaceChildren(
    ...found.slice(0, 50).map((hit) => {
      const item = document.createElement('li');
      item.append(
        Object.assign(document.createElement('a'), { href: hit.page, textContent: hit.title }),
        excerpt(hit.text, hit.terms),
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

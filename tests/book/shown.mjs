/** What of a page could change: numbers, formulae, tables, the terminal, drawings. The page itself runs it. */
export const shown = () => {
  const drawn = (svg) => svg.outerHTML.replace(/<(title|desc)[^]*?<\/\1>/g, '');
  const all = (selector, what) => [...document.querySelectorAll(selector)].map(what);
  return {
    numbers: all(
      'main data[data-name]',
      (e) => `${e.dataset.name}|${e.textContent}|${e.getAttribute('value')}`,
    ),
    formulae: all('main .katex', (e) => e.innerHTML),
    tables: all('main table[data-table] tbody', (e) => e.innerHTML),
    terminal: all('main pre.told code', (e) => e.innerHTML.replace(/<span class="command">.*?<\/span>/, '')),
    figures: all('main figure[data-figure] .drawing > svg', drawn),
  };
};

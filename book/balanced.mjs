// HTML whose tags match: what Doxygen leaves open is closed, what it closes without having opened is dropped, and a
// paragraph ends where a block begins, as a browser would have it.

const empty = /^(area|base|br|col|embed|hr|img|input|link|meta|source|track|wbr)$/;
const block =
  /^(address|article|aside|blockquote|details|div|dl|fieldset|figure|footer|form|h[1-6]|header|hr|main|nav|ol|p|pre|section|table|ul)$/;

export function balanced(html) {
  const open = [];
  const close = (to) => {
    let out = '';
    while (open.length > to) out += `</${open.pop()}>`;
    return out;
  };
  const text = html.replace(
    /<(script|style|svg|math)\b[^]*?<\/\1>|<(\/?)([a-zA-Z][\w-]*)((?:\s[^<>]*?)?)(\/?)>/g,
    (all, whole, closing, tag, rest, self) => {
      if (whole) return all;
      const name = tag.toLowerCase();
      if (empty.test(name)) return closing ? '' : `<${name}${rest}>`;
      if (closing) {
        const at = open.lastIndexOf(name);
        if (at < 0) return '';
        return close(at);
      }
      let before = '';
      if (block.test(name)) {
        const p = open.lastIndexOf('p');
        if (p >= 0) before = close(p);
      }
      if (self) return `${before}<${name}${rest}></${name}>`;
      open.push(name);
      return `${before}<${name}${rest}>`;
    },
  );
  return (text + close(0)).replace(/<p(?: (?![^>]*\bid=)[^>]*)?>\s*<\/p>/g, ''); // one that has a name is filled later
}

/** Text as HTML. */
export const escape = (text) =>
  String(text).replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/** The apostrophes of print, which prose gets as it is set: not the strokes of x′ and dx′. */
export const printed = (text) =>
  text.replace(/(?<=\p{L})'(?=s(?!\p{L}))|(?<=\p{L}{2})'(?=\p{L}|[\s,;.:)]|$)/gu, '’');

/** Words that a program tells, as HTML. */
export const said = (words) => printed(escape(words));

// words.js - the words of the scene language, which the module takes from the parser's own tables (tools/web/page_words.c):
// colours a line, and finds what a word can be completed to.

// statements: name -> {names: it is followed by a name, fields: [[word, values]]}.
let statements = new Map();
export const setWords = list => { statements = new Map(list.map(one => [one.word, one])); };
export const statementNames = () => [...statements.keys()];

const TOKEN = /#.*|[^\s#]\S*/g, NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

const fieldsOf = word => (statements.get(word) || {fields: []}).fields;

// Splits a line into [begin, end, kind]: statement, field, number, comment, name or unknown.
export function tokens(line) {
  let first = null, fields = new Set();
  return [...line.matchAll(TOKEN)].map(({0: word, index}) => {
    let kind = 'name';
    if (word[0] === '#') kind = 'comment';
    else if (first === null) {
      first = word;
      fields = new Set(fieldsOf(word).map(([name]) => name));
      kind = statements.has(word) ? 'statement' : statements.size ? 'unknown' : 'name';
    } else if (NUMBER.test(word)) kind = 'number';
    else if (fields.has(word)) kind = 'field';
    return [index, index + word.length, kind];
  });
}

// Names that statements like `material NAME` define in the text.
function namesOf(kind, text) {
  return [...new Set([...text.matchAll(new RegExp(`^[ \\t]*${kind}[ \\t]+(\\S+)`, 'gm'))].map(match => match[1]))];
}

const NAMED = ['material', 'texture', 'mesh', 'grid'];

// Returns {begin, list: [[word, note]]} for the word that ends at `at` of the line; `all`: also for an empty word.
export function completions(line, at, text, all) {
  const before = line.slice(0, at), begin = before.search(/\S*$/), part = before.slice(begin);
  const words = before.slice(0, begin).trim().split(/\s+/).filter(Boolean), [first] = words, last = words[words.length - 1];
  if ((!part && !all) || before.includes('#') || /^\S/.test(line.slice(at))) return {begin, list: []};
  let list;
  if (!words.length) list = [...statements.keys()].sort().map(word => [word, '']);
  else if (words.length > 1 && NAMED.includes(last)) list = namesOf(last, text).map(word => [word, last]);
  else if (words.length === 1 && first === 'instance') list = ['mesh', 'grid'].flatMap(kind => namesOf(kind, text).map(word => [word, kind]));
  else list = fieldsOf(first).filter(([word]) => !words.includes(word)).sort(([a], [b]) => a < b ? -1 : 1);
  return {begin, list: list.filter(([word]) => word.startsWith(part) && word !== part)};
}

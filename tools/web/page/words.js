// words.js - the words of the scene language, from language.json, which is made from the manual and the parser's tables
// (tools/generate/language.py): colours a line, and finds what a word can be completed to.

// statements: name -> [[property, the words before it on which it depends]]; beginnings: words of lines inside statements, as `vertex`.
let statements = new Map(), beginnings = new Set();

export function setWords({statements: names, properties}) {
  statements = new Map(Object.keys(names).map(name => [name, []]));
  const rows = Object.entries(properties).flatMap(([word, uses]) => uses.map(({of, kind}) => ({word, path: of.split(' '), kind})));
  for (const {word, path: [first, ...path], kind} of rows)
    if (kind !== 'line' && statements.has(first)) statements.get(first).push([word, path]);
  beginnings = new Set([...statements.keys(), ...rows.filter(row => row.kind === 'line').map(row => row.word)]);
}

export const statementNames = () => [...statements.keys()];

const TOKEN = /#.*|[^\s#]\S*/g, NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

// Returns the properties that may follow the words of a line.
const propertiesAfter = words => new Set((statements.get(words[0]) || []).filter(([, path]) => path.every(one => words.includes(one))).map(([word]) => word));

// Splits a line into [begin, end, kind]: statement, field, number, comment, name or unknown.
export function tokens(line) {
  const words = [];
  return [...line.matchAll(TOKEN)].map(({0: word, index}) => {
    let kind = 'name';
    if (word[0] === '#') kind = 'comment';
    else if (!words.length) kind = beginnings.has(word) ? 'statement' : beginnings.size ? 'unknown' : 'name';
    else if (NUMBER.test(word)) kind = 'number';
    else if (propertiesAfter(words).has(word)) kind = 'field';
    if (kind !== 'comment') words.push(word);
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
  else list = [...propertiesAfter(words)].filter(word => !words.includes(word)).sort().map(word => [word, '']);
  return {begin, list: list.filter(([word]) => word.startsWith(part) && word !== part)};
}

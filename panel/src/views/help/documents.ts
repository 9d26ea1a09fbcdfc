// The documents of the manual, as stanok-web has them: read when somebody looks for something, as Markdown.
// Knows nothing of the framework.
import { lexer, type Token, type Tokens } from 'marked';
import { front, prefix, type Place } from './place';

export interface Section extends Place {
  /** Of the document, and of the section in it. */
  titles: string[];
  text: string;
}

export interface Document {
  file: string;
  title: string;
  tokens: Token[];
  sections: Section[];
}

/** The name that a heading is linked by, as code hosts make it. */
export function slugOf(heading: string): string {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .trim()
    .replace(/\s/g, '-');
}

/** Where a link of a document leads within the manual; null: out of it. */
export function targetOf(from: string, href: string): Place | null {
  if (/^[a-z]+:/i.test(href)) return null;
  const url = new URL(href, `http://manual/docs/${from}`);
  if (!url.pathname.startsWith('/docs/')) return null;
  return {
    file: url.pathname.slice('/docs/'.length),
    heading: url.hash.slice(1),
  };
}

/** What a token says, without its marks. */
export function textOf(token: Token): string {
  const { type } = token;
  if (type === 'table') {
    const { header, rows } = token as Tokens.Table;
    return [header, ...rows].map((row) => row.map((cell) => cell.text).join(' ')).join('\n');
  }
  if (type === 'list') return (token as Tokens.List).items.map(textOf).join('\n');
  if (type === 'space' || type === 'html' || type === 'image') return '';
  if ('tokens' in token && token.tokens !== undefined) return token.tokens.map(textOf).join('');
  return 'text' in token ? String(token.text) : '';
}

/** A document from its text. */
export function documentOf(file: string, text: string): Document {
  const tokens = lexer(text);
  const sections: Section[] = [];
  let title = file;
  for (const token of tokens) {
    if (token.type === 'heading') {
      const name = textOf(token);
      const isFirst = sections.length === 0;
      if (isFirst) title = name;
      const titles = isFirst ? [name] : [title, name];
      sections.push({
        file,
        heading: isFirst ? '' : slugOf(name),
        titles,
        text: '',
      });
    } else {
      const section = sections[sections.length - 1];
      if (section !== undefined) section.text += `${textOf(token)}\n`;
    }
  }
  return { file, title, tokens, sections };
}

function linksOf(token: Token): string[] {
  if (token.type === 'link') return [(token as Tokens.Link).href];
  const within =
    token.type === 'list' ? (token as Tokens.List).items : (token as Tokens.Generic).tokens;
  return (within ?? []).flatMap(linksOf);
}

const read = new Map<string, Promise<Document>>();

export function documentAt(file: string): Promise<Document> {
  let known = read.get(file);
  if (known === undefined) {
    known = fetch(prefix + file).then(async (answer) => {
      if (!answer.ok) throw new Error(await answer.text());
      return documentOf(file, await answer.text());
    });
    read.set(file, known);
    known.catch(() => read.delete(file));
  }
  return known;
}

/** All documents that the front one has links to, and itself. */
export async function allDocuments(): Promise<Document[]> {
  const first = await documentAt(front);
  const files = first.tokens
    .flatMap(linksOf)
    .map((href) => targetOf(front, href)?.file)
    .filter((file): file is string => file !== undefined && file.endsWith('.md'));
  const rest = [...new Set(files)].filter((file) => file !== front);
  return [first, ...(await Promise.all(rest.map(documentAt)))];
}

/** The sections that have all of the words, those with them in their title first. */
export function sectionsWith(documents: readonly Document[], words: readonly string[]): Section[] {
  const has = (text: string): boolean => {
    const low = text.toLowerCase();
    return words.every((word) => low.includes(word));
  };
  const found = documents
    .flatMap(({ sections }) => sections)
    .filter(({ titles, text }) => has(`${titles.join(' ')} ${text}`));
  const isTitled = ({ titles }: Section): boolean => has(titles[titles.length - 1] ?? '');
  return [...found.filter(isTitled), ...found.filter((one) => !isTitled(one))];
}

const around = 90;

/** Some of the text of a section around the first of the words that it has. */
export function excerptOf({ text }: Section, words: readonly string[]): string {
  const low = text.toLowerCase();
  const places = words.map((word) => low.indexOf(word)).filter((place) => place >= 0);
  const from = Math.max(0, Math.min(...places, text.length) - around);
  const part = text.slice(
    places.length > 0 ? from : 0,
    (places.length > 0 ? from : 0) + 2 * around,
  );
  return `${from > 0 && places.length > 0 ? '… ' : ''}${part.replace(/\s+/g, ' ').trim()} …`;
}

import { describe, expect, it } from 'vitest';
import {
  documentOf,
  excerptOf,
  sectionsWith,
  slugOf,
  targetOf,
} from '../../src/views/help/documents';
import { addressOf, placeOf } from '../../src/views/help/place';

const page = documentOf(
  'operator/page.md',
  `# The page

It shows a *machine*, see [users](#users-and-roles).

## Users and roles

| role | may |
|---|---|
| observer | \`look\` |

- an item with **weight**
`,
);

describe('a document', () => {
  it('has its title and a section for each heading, with the text and without the marks', () => {
    expect(page.title).toBe('The page');
    expect(page.sections.map(({ heading, titles }) => [heading, titles])).toEqual([
      ['', ['The page']],
      ['users-and-roles', ['The page', 'Users and roles']],
    ]);
    expect(page.sections[0]?.text).toContain('It shows a machine, see users.');
    expect(page.sections[1]?.text).toContain('an item with weight');
  });

  it('is found by all of the words, titles first', () => {
    const other = documentOf('b.md', '# Observer\n\nnothing\n');
    const found = sectionsWith([page, other], ['observer']);
    expect(found.map(({ file }) => file)).toEqual(['b.md', 'operator/page.md']);
    expect(sectionsWith([page, other], ['observer', 'weight']).length).toBe(1);
    expect(sectionsWith([page, other], ['observer', 'anvil'])).toEqual([]);
  });

  it('shows text around the word that was looked for', () => {
    const long = documentOf(
      'c.md',
      `# Long\n\n${'before '.repeat(50)}anvil${' behind'.repeat(50)}\n`,
    );
    const [section] = sectionsWith([long], ['anvil']);
    expect(section === undefined ? '' : excerptOf(section, ['anvil'])).toMatch(/^… .*anvil.* …$/);
  });
});

describe('places', () => {
  it('survive the address of the page', () => {
    const place = { file: 'operator/panel.md', heading: 'from-the-network' };
    const address = decodeURIComponent(addressOf(place).replace('#/help/', ''));
    expect(placeOf(address)).toEqual(place);
    expect(placeOf('manual/')).toEqual({ file: 'README.md', heading: '' });
    expect(placeOf('E6070')).toBeNull();
  });

  it('of links lie beside the document that has them, or nowhere', () => {
    expect(targetOf('operator/panel.md', 'panel-views.md#keys')).toEqual({
      file: 'operator/panel-views.md',
      heading: 'keys',
    });
    expect(targetOf('operator/panel.md', '../reference/protocol.md')?.file).toBe(
      'reference/protocol.md',
    );
    expect(targetOf('operator/panel.md', '#users')).toEqual({
      file: 'operator/panel.md',
      heading: 'users',
    });
    expect(targetOf('operator/panel.md', '../../SECURITY.md')).toBeNull();
    expect(targetOf('operator/panel.md', 'https://example.org/x.md')).toBeNull();
  });

  it('of headings are named as code hosts name them', () => {
    expect(slugOf('Beginning in the middle')).toBe('beginning-in-the-middle');
    expect(slugOf('4. `#workpiece`: the blank')).toBe('4-workpiece-the-blank');
    expect(slugOf('Lines by their angle (,A)')).toBe('lines-by-their-angle-a');
  });
});

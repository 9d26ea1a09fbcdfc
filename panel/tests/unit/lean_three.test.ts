// The build leaves methods out that nothing calls, and none that something does.
import { describe, expect, it } from 'vitest';
import { withoutUnusedMethods } from '../../tools/lean_three';

const left = (code: string, ...others: string[]): string[] =>
  [...withoutUnusedMethods(code, others).matchAll(/(\w+)\(\) \{|this\.(\w+) = function/g)].map(
    ([, method, own]) => method ?? own ?? '',
  );

describe('Unused methods are left out of the page', () => {
  it('what nothing says, and what only such a method says', () => {
    const code = 'class A { used() {} first() { this.second(); } second() { this.first(); } }';
    expect(left(`${code} new A().used();`)).toEqual(['used']);
  });
  it('a variable or a key of the same name is no call', () => {
    const code = 'class A { line() {} } let line = { line: 1 }; line = line + 1; new A();';
    expect(left(code)).toEqual([]);
  });
  it('what a used method says is used, in whatever class', () => {
    const code = 'class A { one() { return b.two(); } } class B { two() {} three() {} }';
    expect(left(`${code} new A().one();`)).toEqual(['one', 'two']);
  });
  it('what another piece of the page calls, takes out or names in a text stays', () => {
    const code = 'export class A { call() {} taken() {} named() {} get other() {} }';
    expect(left(code, 'a.call(); const { taken } = a; a["named"]();')).toEqual([
      'call',
      'taken',
      'named',
    ]);
  });
  it('functions that a constructor gives its object are as methods; of the language no name counts', () => {
    const code = `class A { constructor() {
      this.used = function () {}; this.unused = function () {}; }
      toString() {} toJSON() {} }`;
    expect(left(`${code} new A().used();`)).toEqual(['constructor', 'used', 'toString']);
    expect(left(`${code} f.toJSON();`)).not.toContain('toJSON');
  });
});

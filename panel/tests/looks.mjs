// What is wrong with how a page looks: sizes of what is in view, and what axe-core finds.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

export async function findings(page) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(document));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' | ')}`);
}

/** What is wrong with the sizes of what is in view, as sentences. */
export function measure() {
  const wrong = [];
  const wide = document.documentElement.scrollWidth - window.innerWidth;
  if (wide > 0) wrong.push(`the page is ${wide} px too wide`);
  for (const element of document.querySelectorAll('button, select, input, nav a, a.button')) {
    const box = element.getBoundingClientRect();
    const hidden = box.width === 0 || element.closest('[hidden], details:not([open])');
    if (!hidden && (box.height < 43.9 || (box.width < 43.9 && element.type !== 'range'))) {
      wrong.push(`${element.outerHTML.slice(0, 90)} is ${box.width} x ${box.height} px`);
    }
  }
  for (const element of document.querySelectorAll('td, th, h1, h2, button, strong, dd')) {
    const spills = element.scrollWidth - element.clientWidth > 1 && element.clientWidth > 1;
    const cut = getComputedStyle(element).overflow !== 'visible';
    if (spills && !cut) wrong.push(`${element.outerHTML.slice(0, 90)} spills over`);
  }
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const { parentElement, textContent } = texts.currentNode;
    if (textContent.trim() === '' || parentElement.closest('script, style')) continue;
    const size = parseFloat(getComputedStyle(parentElement).fontSize);
    if (size < 14) wrong.push(`"${textContent.trim().slice(0, 30)}" is written with ${size} px`);
  }
  return wrong;
}

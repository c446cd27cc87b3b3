import { h } from './dom';

function copyButton(text: string): HTMLElement {
  const button = h('button', { type: 'button', id: 'copy' }, 'Copy');
  button.addEventListener('click', () => {
    const done = () => (button.textContent = 'Copied');
    navigator.clipboard?.writeText(text).then(done, () => (button.textContent = 'Select and copy'));
  });
  return button;
}

export const commandToRepeat = (line: string): HTMLElement[] => [
  h('h3', {}, 'To repeat this run'),
  h('pre', {}, line),
  copyButton(line),
];

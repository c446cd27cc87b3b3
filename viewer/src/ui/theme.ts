import { h } from './dom';

const NEXT: Record<string, string> = { auto: 'light', light: 'dark', dark: 'auto' };

/** Light, dark, or as the system has it. */
export function themeButton(onChange: () => void): HTMLElement {
  const button = h('button', { type: 'button', id: 'theme' });
  const show = (theme: string) => {
    document.documentElement.dataset.theme = theme;
    button.textContent = `Theme: ${theme}`;
    onChange();
  };
  button.addEventListener('click', () =>
    show(NEXT[document.documentElement.dataset.theme ?? 'auto'] ?? 'auto'),
  );
  show('auto');
  return button;
}

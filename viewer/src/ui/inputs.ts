import { h } from './dom';

export interface Choice<Value extends string> {
  value: Value;
  name: string;
}

/** Buttons of which one is pressed; `show` presses another. */
export function choiceOf<Value extends string>(
  name: string,
  legend: string,
  choices: readonly Choice<Value>[],
  choose: (value: Value) => void,
): { element: HTMLElement; show: (value: Value) => void } {
  const element = h('fieldset', { class: 'choices' }, h('legend', {}, legend));
  const inputs = choices.map(({ value, name: label }) => {
    const input = h('input', { type: 'radio', name, value, change: () => choose(value) });
    element.append(h('label', {}, input, h('span', {}, label)));
    return input;
  });
  const show = (value: Value) => inputs.forEach((input) => (input.checked = input.value === value));
  return { element, show };
}

export interface SliderOptions {
  id: string;
  label: string;
  min?: number;
  max: number;
  step?: number;
  describe: (value: number) => string;
  change: (value: number) => void;
}

/** A slider that says its value; `show` moves it. */
export function sliderOf(options: SliderOptions): {
  element: HTMLElement;
  show: (value: number) => void;
} {
  const { id, label, min = 0, max, step = 1, describe, change } = options;
  const output = h('output');
  const input = h('input', { type: 'range', min, max, step, id });
  input.addEventListener('input', () => change(Number(input.value)));
  const show = (value: number) => {
    input.value = String(value);
    output.textContent = describe(value);
  };
  const element = h('div', { class: 'slider' }, h('label', { for: id }, label), output, input);
  return { element, show };
}

/** Three significant digits; large whole numbers in full. */
export function number(value: number): string {
  if (Number.isNaN(value)) return '–';
  if (Number.isInteger(value)) return value.toLocaleString('en');
  if (value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e5))
    return value.toExponential(2);
  return Number(value.toPrecision(3)).toString();
}

export const percent = (share: number): string =>
  Number.isNaN(share) ? '–' : `${Number((100 * share).toPrecision(3))} %`;

export const seconds = (value: number): string =>
  value < 1 ? `${Math.round(1000 * value)} ms` : `${Number(value.toPrecision(3))} s`;

/** As a shell takes it. */
export const quote = (word: string): string =>
  /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;

/** The last part of a path. */
export const fileName = (path: string): string => path.split('/').pop() || path;

/** With one decimal and a sign. */
export function deviation(value: number): string {
  const digits = Math.abs(value).toFixed(1);
  return Number(digits) === 0 ? digits : (value < 0 ? '−' : '+') + digits;
}

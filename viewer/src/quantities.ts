// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.

/** The greatest of 1, 2, 5, 10, ... (times a power of ten) that is not above `value`, which is positive. */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  const digit = value / power;
  return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
}

const prefixes: [number, string][] = [
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
];

/** With three digits and a prefix: 0.0123 m is "12.3 mm". A number without unit takes no prefix. */
export function withUnit(value: number, unit: string): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (unit === "" || size === 0) return `${trimmed(value)} ${unit}`.trim();
  const [factor, prefix] = prefixes.find(([least]) => size >= 0.9995 * least) ?? [1e-6, "µ"];
  return `${trimmed(value / factor)} ${prefix}${unit}`;
}

/** As withUnit, for round numbers, whose zeros behind the point say nothing: 5 mm, not 5.00 mm. */
export function roundWithUnit(value: number, unit: string): string {
  return withUnit(value, unit).replace(/\.0+(?= |$)/, "");
}

/** At most three significant digits, more where the integer part has more. */
export function trimmed(value: number): string {
  const size = Math.abs(value);
  if (size >= 100) return value.toFixed(0);
  if (size >= 10) return value.toFixed(1);
  if (size >= 1) return value.toFixed(2);
  return value === 0 ? "0" : String(Number(value.toPrecision(3)));
}

/** A count with narrow spaces between its thousands. */
export function grouped(value: number): string {
  return value.toFixed(0).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

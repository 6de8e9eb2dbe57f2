// SPDX-License-Identifier: Apache-2.0

/**
 * Evaluated in a page: the texts whose contrast to their ground (WCAG 2, relative luminance) is below `least`. A ground
 * that lets something through is taken over the 3-D view's darkest and lightest, black and white.
 */
export function faintTexts(least) {
  const parse = (text) => {
    const [r = 0, g = 0, b = 0, a = 1] = (text.match(/[\d.]+/g) ?? []).map(Number);
    return [r, g, b, a];
  };
  const over = ([r, g, b, a], [R, G, B]) => [r * a + R * (1 - a), g * a + G * (1 - a), b * a + B * (1 - a)];
  const luminance = (colour) => {
    const [r, g, b] = colour.map((part) => {
      const value = part / 255;
      return value <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const contrast = (one, other) => {
    const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  };
  const groundOf = (element, behind) => {
    const grounds = [];
    for (let each = element; each; each = each.parentElement) {
      const ground = parse(getComputedStyle(each).backgroundColor);
      if (ground[3] > 0) grounds.push(ground);
      if (ground[3] === 1) break;
    }
    return grounds.reverse().reduce((below, ground) => over(ground, below), behind);
  };
  const faint = [];
  for (const element of document.querySelectorAll("body *")) {
    const ownText = [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim() !== "");
    const isOff = element.matches(":disabled, option, script") || !element.checkVisibility();
    if (!ownText || isOff) continue;
    const inView = element.closest("#stage") !== null;
    for (const behind of inView ? [[0, 0, 0], [255, 255, 255]] : [[0, 0, 0]]) {
      const ground = groundOf(element, behind);
      const ink = over(parse(getComputedStyle(element).color), ground);
      const found = contrast(ink, ground);
      if (found < least) faint.push(`${element.textContent.trim().slice(0, 40)}: ${found.toFixed(2)}`);
    }
  }
  return faint;
}

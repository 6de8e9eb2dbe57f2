// SPDX-License-Identifier: Apache-2.0

/** Those who want to know of a value, in the order in which they said so. */
export class Emitter<Value> {
  private readonly listeners: ((value: Value) => void)[] = [];

  listen(listener: (value: Value) => void): void {
    this.listeners.push(listener);
  }

  emit(value: Value): void {
    for (const listener of this.listeners) listener(value);
  }
}

// SPDX-License-Identifier: Apache-2.0
import type { Vector } from "../protocol";
import type { HandVelocity, VelocitySource } from "./velocity_source";

const fullDeflection = 350; // counts
const deadZone = 0.04; // of it
const silence = 300; // ms without a report after which the cap is taken as at rest

/** Of WebHID, what is used here; TypeScript's library does not describe it. */
interface HidDevice extends EventTarget {
  readonly opened: boolean;
  open(): Promise<void>;
}
interface HidReport extends Event {
  readonly reportId: number;
  readonly data: DataView;
}
interface Hid {
  requestDevice(options: { filters: { vendorId: number; usagePage?: number; usage?: number }[] }): Promise<HidDevice[]>;
}

/** Deflections of the cap: x to the right, y towards the user, z down, each from -1 to 1, and turns about them. */
export interface CapState {
  translation: Vector;
  rotation: Vector;
}

function vectorAt(data: DataView, offset: number): Vector {
  const part = (i: number) => {
    const value = data.getInt16(offset + 2 * i, true) / fullDeflection;
    return Math.abs(value) < deadZone ? 0 : Math.max(-1, Math.min(1, value));
  };
  return [part(0), part(1), part(2)];
}

/** The cap after an input report: 1 is translation, or all six where it is long enough; 2 is rotation. */
export function capAfter(cap: CapState, reportId: number, data: DataView): CapState {
  if (reportId === 1 && data.byteLength >= 12) {
    return { translation: vectorAt(data, 0), rotation: vectorAt(data, 6) };
  }
  if (reportId === 1 && data.byteLength >= 6) return { ...cap, translation: vectorAt(data, 0) };
  if (reportId === 2 && data.byteLength >= 6) return { ...cap, rotation: vectorAt(data, 0) };
  return cap;
}

/** The cap's axes are right, towards and down; the hand's are right, up and away. */
export function capVelocity({ translation, rotation }: CapState): HandVelocity | null {
  if ([...translation, ...rotation].every((value) => value === 0)) return null;
  const toHand = ([x, y, z]: Vector): Vector => [x, -z, -y];
  return { linear: toHand(translation), angular: toHand(rotation) };
}

/** A 3Dconnexion device by WebHID, where the browser has it. */
export class SpaceMouse implements VelocitySource {
  readonly name = "SpaceMouse";
  private cap: CapState = { translation: [0, 0, 0], rotation: [0, 0, 0] };
  private lastReport = -Infinity;
  private readonly hid = (navigator as Navigator & { hid?: Hid }).hid;

  get isPossible(): boolean {
    return this.hid !== undefined;
  }

  /** Asks the user for the device; called from a click. Gives false where none was chosen. */
  async connect(): Promise<boolean> {
    const multiAxis = { usagePage: 1, usage: 8 };
    const filters = [0x046d, 0x256f].map((vendorId) => ({ vendorId, ...multiAxis }));
    const devices = (await this.hid?.requestDevice({ filters })) ?? [];
    for (const device of devices) {
      if (!device.opened) await device.open();
      device.addEventListener("inputreport", (event) => {
        const report = event as HidReport;
        this.cap = capAfter(this.cap, report.reportId, report.data);
        this.lastReport = performance.now();
      });
    }
    return devices.length > 0;
  }

  read(): HandVelocity | null {
    return performance.now() - this.lastReport < silence ? capVelocity(this.cap) : null;
  }
}

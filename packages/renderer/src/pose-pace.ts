/**
 * For which moments meshes are to be bent while a page draws: one pose a frame. Where the device is quick the next one is asked for as soon as
 * a frame begins, and is there for the next. Where it is slow that would be old by then: it is asked for when the device is at its
 * last frame, which gives time enough.
 */
import type { Moment } from './scene/motion.ts';

/** A pose that is this late, seconds, is worth another one if the device has something to do meanwhile. */
const LATEST = 0.05;

export class PosePace {
  #wanted: Moment | null = null;
  /** Whether it was asked for when a frame could have been begun. */
  #isFresh = true;

  /** The moment that is to be drawn next. `busy`: the device has something to do. */
  wants(now: Moment, busy: boolean): Moment {
    const wanted = this.#wanted;
    const isOld = wanted !== null && Math.abs(now.time - wanted.time) > LATEST;
    if (wanted?.played === now.played && !(isOld && busy && !this.#isFresh)) return wanted;
    this.#wanted = now;
    this.#isFresh = true;
    return now;
  }

  /** It is being drawn. Returns whether to ask for the next one at once. */
  drawn(busy: boolean): boolean {
    const isQuick = !(this.#isFresh && busy);
    this.#wanted = null;
    return isQuick;
  }

  /** This one has been asked for. */
  asked(moment: Moment): void {
    this.#wanted = moment;
    this.#isFresh = false;
  }
}

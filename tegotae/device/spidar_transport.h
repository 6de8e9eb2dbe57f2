/* SPDX-License-Identifier: Apache-2.0 */
/**
 * What a shared library must offer so that Tegotae drives the motors and encoders of a SPIDAR through it, in plain C:
 *
 *     tegotae serve SCENE --interface spidar-g6:x3r,transport=/path/libmyboard.so
 *
 * Include this file, define every function below, and build a shared library:
 *
 *     cc -shared -fPIC -o libmyboard.so myboard.c
 *
 * docs/spidar.md, "Drive your own hardware", says what else matters; examples/spidar_board.c is one such library.
 *
 * Calls for one board never overlap, but come from different threads. `read` and `write` are called once each in a
 * haptic period (1 ms), so they must not wait for longer than a part of it, nor allocate. A result of 0 is fine; any
 * other is an error: nothing came or went. Tegotae answers every error with least tensions, then gives the board up:
 * after ten periods of errors on end it is closed, and opened again every second on another thread.
 *
 * **Motors must let go by themselves where no `write` has come for some time** (20 to 100 ms), by a watchdog on the
 * board, unless `tegotae_spidar_sharing` lets another process stop them: a program that was killed calls nothing.
 */
#ifndef TEGOTAE_DEVICE_SPIDAR_TRANSPORT_H
#define TEGOTAE_DEVICE_SPIDAR_TRANSPORT_H

/* Names as C libraries have them. NOLINTBEGIN(readability-identifier-naming) */

#ifdef __cplusplus
extern "C" {
#endif

/** Version of this file. It changes whenever a library made for one would be wrong for the other. */
#define TEGOTAE_SPIDAR_VERSION 1

/** Strings that Tegotae drives, in the order of the geometry file (of a preset: motors 0 to 7 of its table). */
#define TEGOTAE_SPIDAR_STRINGS 8

/** Visible also where a library hides its other functions (-fvisibility=hidden). */
#define TEGOTAE_SPIDAR_FUNCTION __attribute__((visibility("default")))

/** An open board: the library's own. */
typedef struct tegotae_spidar_board tegotae_spidar_board;

/** What a board measured. Zeroed by the caller, so what a library does not know it leaves. */
typedef struct tegotae_spidar_reading {
  double counts[TEGOTAE_SPIDAR_STRINGS]; /**< pulses since `reset`, fractions where the board interpolates */
  double age;                            /**< s from when they were measured to the return of `read`; 0: not known */
  unsigned buttons;                      /**< of the grip, a bit each; 1: pressed */
  /** 1: the counters lost their zero since `reset` (the board had no power, say), so they tell no pose. */
  int is_uncalibrated;
} tegotae_spidar_reading;

/** When another process may open a board, stop it and close it, beside the one that drives it. */
enum {
  TEGOTAE_SPIDAR_NEVER = 0,       /**< or not for sure: after a crash the board's own watchdog must let go */
  TEGOTAE_SPIDAR_AFTER_DEATH = 1, /**< once the process that drove it is dead */
  /** Also while that process lives, and has it open; the library then repeats no `write` by itself. */
  TEGOTAE_SPIDAR_ANY_TIME = 2
};

/** TEGOTAE_SPIDAR_VERSION, as this library was compiled with. Asked first: any other than Tegotae's own is refused. */
TEGOTAE_SPIDAR_FUNCTION int tegotae_spidar_version(void);

/** One of the three above. May be asked without a board. */
TEGOTAE_SPIDAR_FUNCTION int tegotae_spidar_sharing(void);

/**
 * Opens the board that `options` name: what stands after `board=` on the command line, "" where nothing does. Motors
 * stay as they are, counters too. Null: it cannot be opened. May take seconds.
 */
TEGOTAE_SPIDAR_FUNCTION tegotae_spidar_board* tegotae_spidar_open(const char* options);

/** How many strings the board has. Other than TEGOTAE_SPIDAR_STRINGS is refused. */
TEGOTAE_SPIDAR_FUNCTION int tegotae_spidar_strings(tegotae_spidar_board* board);

/** Now the grip is in the middle of the frame, unrotated: all counts are zero here. */
TEGOTAE_SPIDAR_FUNCTION int tegotae_spidar_reset(tegotae_spidar_board* board);

TEGOTAE_SPIDAR_FUNCTION int tegotae_spidar_read(tegotae_spidar_board* board, tegotae_spidar_reading* reading);

/**
 * Tension of each string, N, to be held until the next `write`. From the geometry's least to its greatest tension; the
 * library converts to its motors' current (a pulley of radius r and a motor of k N m/A take r/k A per newton). Nothing
 * may queue up, as it would display forces that are old: what the board cannot take now is an error.
 */
TEGOTAE_SPIDAR_FUNCTION int tegotae_spidar_write(tegotae_spidar_board* board, const double* tensions);

/** Takes the current off all motors, at once. A `write` that follows displays again. */
TEGOTAE_SPIDAR_FUNCTION int tegotae_spidar_stop(tegotae_spidar_board* board);

/** Frees `board`, whatever state it is in. It was stopped before. */
TEGOTAE_SPIDAR_FUNCTION void tegotae_spidar_close(tegotae_spidar_board* board);

/** Why the last call of the calling thread failed, for people: some words without a full stop. Null or "": not known. */
TEGOTAE_SPIDAR_FUNCTION const char* tegotae_spidar_error(void);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(readability-identifier-naming) */

#endif

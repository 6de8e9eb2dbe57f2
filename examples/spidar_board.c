/* SPDX-License-Identifier: Apache-2.0 */
/* A SPIDAR's board behind a serial port, as Tegotae loads it. Its packets are made up; put those of yours in their
   place:  'w' and eight floats: motor currents, A;  'z': counts are zero here;  'r': answers eight int32 counts. The
   board must let go of the motors by itself 50 ms after the last 'w'. */
#include <tegotae/device/spidar_transport.h>

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

struct tegotae_spidar_board {
  int port;
};

static const float kAmperesPerNewton = 0.008F / 0.0438F; /* radius of the pulley, m, over the motor's N m/A */
static const int kWait = 2;                              /* ms for an answer */
static const int kMostWaiting = 64;                      /* bytes not yet on the line: about a period's */
static _Thread_local const char* error = "";

static int failed(void) {
  error = errno == 0 ? "the board did not answer in time" : strerror(errno);
  return -1;
}

static int sent(int port, const void* bytes, size_t size) {
  errno = 0;
  return write(port, bytes, size) == (ssize_t)size ? 0 : failed();
}

int tegotae_spidar_version(void) { return TEGOTAE_SPIDAR_VERSION; }

/* A port can be opened twice, and the board takes packets from either. */
int tegotae_spidar_sharing(void) { return TEGOTAE_SPIDAR_ANY_TIME; }

tegotae_spidar_board* tegotae_spidar_open(const char* options) {
  struct termios mode;
  tegotae_spidar_board* board = malloc(sizeof *board);
  if (board == NULL) return NULL;
  errno = 0;
  board->port = open(options, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (board->port >= 0 && tcgetattr(board->port, &mode) == 0) {
    cfmakeraw(&mode);
    cfsetspeed(&mode, B921600); /* 66 bytes a millisecond; USB takes no notice */
    if (tcsetattr(board->port, TCSANOW, &mode) == 0) return board;
  }
  failed();
  if (board->port >= 0) close(board->port);
  free(board);
  return NULL;
}

void tegotae_spidar_close(tegotae_spidar_board* board) {
  close(board->port);
  free(board);
}

int tegotae_spidar_strings(tegotae_spidar_board* board) {
  (void)board;
  return TEGOTAE_SPIDAR_STRINGS;
}

int tegotae_spidar_reset(tegotae_spidar_board* board) { return sent(board->port, "z", 1); }

int tegotae_spidar_read(tegotae_spidar_board* board, tegotae_spidar_reading* reading) {
  int32_t counts[TEGOTAE_SPIDAR_STRINGS];
  size_t got = 0;
  tcflush(board->port, TCIFLUSH); /* an answer that came too late the last time */
  if (sent(board->port, "r", 1) != 0) return -1;
  while (got < sizeof counts) {
    struct pollfd answer = {board->port, POLLIN, 0};
    ssize_t more;
    errno = 0;
    if (poll(&answer, 1, kWait) <= 0) return failed();
    more = read(board->port, (char*)counts + got, sizeof counts - got);
    if (more <= 0) return failed();
    got += (size_t)more;
  }
  for (int i = 0; i < TEGOTAE_SPIDAR_STRINGS; ++i) reading->counts[i] = counts[i];
  return 0;
}

static int tell(int port, const double* tensions) {
  char packet[1 + TEGOTAE_SPIDAR_STRINGS * sizeof(float)] = {'w'};
  for (int i = 0; i < TEGOTAE_SPIDAR_STRINGS; ++i) {
    const float amperes = kAmperesPerNewton * (float)tensions[i];
    memcpy(packet + 1 + (size_t)i * sizeof amperes, &amperes, sizeof amperes);
  }
  return sent(port, packet, sizeof packet);
}

int tegotae_spidar_write(tegotae_spidar_board* board, const double* tensions) {
  int waiting = 0;
  if (ioctl(board->port, TIOCOUTQ, &waiting) == 0 && waiting > kMostWaiting) {
    errno = EAGAIN; /* a queue would display forces that are old */
    return failed();
  }
  return tell(board->port, tensions);
}

int tegotae_spidar_stop(tegotae_spidar_board* board) {
  const double none[TEGOTAE_SPIDAR_STRINGS] = {0.0};
  return tell(board->port, none);
}

const char* tegotae_spidar_error(void) { return error; }

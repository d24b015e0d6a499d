package tellosimulator.command;

/** The values that can be read from the drone by commands with a question mark. */
public enum Reading {
  SPEED,
  BATTERY,
  TIME,
  WIFI,
  SDK,
  SERIAL_NUMBER,
  HEIGHT,
  TEMPERATURE,
  ATTITUDE,
  BAROMETER,
  ACCELERATION,
  TOF,
  PAD,
  ACTIVATION,
  HARDWARE,
  WIFI_VERSION,
  JOINED_NETWORK,
  OWN_NETWORK,
  BOARD_TOF,
  BOARD_VERSION
}

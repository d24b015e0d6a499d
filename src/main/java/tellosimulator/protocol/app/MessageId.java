package tellosimulator.protocol.app;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The messages that the drone knows. A message of the app may have any kind: different clients ask
 * for the same with different kinds, and the drone answers all of them.
 */
enum MessageId {
  SSID(0x0011, "ssid?", Sender.APP, "TelloPy, SMerrony/tello"),
  SET_SSID(0x0012, "ssid", Sender.APP, "TelloPy"),
  PASSWORD(0x0013, "password?", Sender.APP, "TelloPy"),
  SET_PASSWORD(0x0014, "password", Sender.APP, "TelloPy"),
  REGION(0x0015, "region?", Sender.APP, "tellopilots.com wiki, nodetello"),
  SET_REGION(0x0016, "region", Sender.APP, "tellopilots.com wiki"),
  WIFI(0x001a, "wifi strength", Sender.DRONE, "gobot, SMerrony/tello"),
  BIT_RATE(0x0020, "setbitrate", Sender.APP, "gobot, SMerrony/tello"),
  DYNAMIC_BIT_RATE(0x0021, "dynamic bit rate", Sender.APP, "TelloLib"),
  STABILIZATION(0x0024, "stabilization", Sender.APP, "TelloLib"),
  KEY_PICTURE(0x0025, "key picture", Sender.APP, "all clients"),
  ASK_BIT_RATE(0x0028, "bitrate?", Sender.APP, "the app's own enum, SMerrony/tello"),
  PHOTO(0x0030, "photo", Sender.APP, "SMerrony/tello, TelloLib, TelloPy 25"),
  PICTURE_MODE(0x0031, "picture mode", Sender.APP, "TelloPy, SMerrony/tello"),
  RECORD(0x0032, "record", Sender.APP, "TelloLib"),
  EXPOSURE(0x0034, "exposure", Sender.APP, "TelloPy, gobot, TelloLib"),
  LIGHT(0x0035, "light strength", Sender.DRONE, "SMerrony/tello, gobot"),
  PHOTO_QUALITY(0x0037, "photo quality", Sender.APP, "TelloLib, the app's own enum"),
  VERSION(0x0045, "version?", Sender.APP, "the app's own enum, nodetello"),
  TIME(0x0046, "time", Sender.BOTH, "TelloPy, gobot, SMerrony/tello"),
  LOADER_VERSION(0x0049, "loader version?", Sender.APP, "the app's own enum"),
  STICKS(0x0050, "rc", Sender.APP, "all clients"),
  TAKEOFF(0x0054, "takeoff", Sender.APP, "all clients"),
  LAND(0x0055, "land", Sender.APP, "TelloPy, gobot, SMerrony/tello"),
  FLIGHT_DATA(0x0056, "flight data", Sender.DRONE, "all clients, a radio capture"),
  SET_HEIGHT_LIMIT(0x0058, "height limit", Sender.APP, "TelloLib, TelloPy"),
  CALIBRATE(0x005a, "calibrate", Sender.APP, "TelloPy"),
  CALIBRATION(0x005b, "calibration?", Sender.APP, "TelloPy 0.7.0, docs/calibration.md"),
  FLIP(0x005c, "flip", Sender.APP, "all clients"),
  THROW_AND_GO(0x005d, "throw and go", Sender.APP, "TelloPy, gobot, SMerrony/tello"),
  PALM_LANDING(0x005e, "palm landing", Sender.APP, "all clients"),
  FILE_SIZE(0x0062, "file size", Sender.BOTH, "SMerrony/tello, TelloLib, TelloPy 25"),
  FILE_DATA(0x0063, "file data", Sender.BOTH, "SMerrony/tello, TelloLib, TelloPy 25"),
  FILE_DONE(0x0064, "file done", Sender.APP, "SMerrony/tello, TelloPy"),
  SMART_VIDEO(0x0080, "smart video", Sender.APP, "SMerrony/tello"),
  LOG_HEADER(0x1050, "log header", Sender.BOTH, "TelloPy, SMerrony/tello"),
  LOG_DATA(0x1051, "log data", Sender.DRONE, "TelloPy, a radio capture"),
  BOUNCE(0x1053, "bounce", Sender.APP, "gobot, SMerrony/tello"),
  BATTERY_THRESHOLD(0x1055, "battery threshold", Sender.APP, "TelloPy, SMerrony/tello"),
  HEIGHT_LIMIT(0x1056, "height limit?", Sender.APP, "SMerrony/tello"),
  ASK_BATTERY_THRESHOLD(0x1057, "battery threshold?", Sender.APP, "TelloPy, the app's own enum"),
  SET_ATTITUDE_LIMIT(0x1058, "attitude limit", Sender.APP, "TelloLib, SMerrony/tello"),
  ASK_ATTITUDE_LIMIT(0x1059, "attitude limit?", Sender.APP, "TelloLib, SMerrony/tello");

  /** Who sends a message of its own accord. */
  enum Sender {
    APP,
    DRONE,
    BOTH
  }

  private static final Map<Integer, MessageId> BY_NUMBER =
      Arrays.stream(values()).collect(Collectors.toMap(MessageId::number, Function.identity()));

  private final int number;
  private final String words;
  private final Sender sender;
  private final String source;

  MessageId(int number, String words, Sender sender, String source) {
    this.number = number;
    this.words = words;
    this.sender = sender;
    this.source = source;
  }

  /** Returns the message with a number; empty if the drone does not know it. */
  static Optional<MessageId> of(int number) {
    return Optional.ofNullable(BY_NUMBER.get(number));
  }

  int number() {
    return number;
  }

  /**
   * Returns the name of the message in logs: if the text protocol has the same command, its verb.
   */
  String words() {
    return words;
  }

  Sender sender() {
    return sender;
  }

  /** Returns the programs from which the message is known. */
  String source() {
    return source;
  }
}

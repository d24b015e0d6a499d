package tellosimulator.command;

import java.util.List;
import java.util.Random;

/**
 * An endless source of texts that a command socket must survive: random bytes, commands that are
 * truncated, mutated or mixed up, numbers of all kinds, and now and then a valid command. The same
 * seed gives the same texts.
 */
public final class GarbageSource {

  private static final List<String> WORDS =
      List.of(
          "command",
          "takeoff",
          "land",
          "up",
          "down",
          "left",
          "right",
          "forward",
          "back",
          "cw",
          "ccw",
          "flip",
          "go",
          "curve",
          "jump",
          "stop",
          "emergency",
          "speed",
          "rc",
          "wifi",
          "ap",
          "mon",
          "moff",
          "mdirection",
          "battery?",
          "speed?",
          "sdk?",
          "sn?",
          "EXT",
          "led",
          "mled",
          "br",
          "bl",
          "port",
          "setfps",
          "setbitrate",
          "reboot",
          "m1",
          "m-2",
          "m9",
          "l",
          "high",
          "Re0101",
          "Re0102",
          "Re\0\1\1\1",
          "conn_req:",
          "\u00cc",
          "",
          " ",
          "\0",
          "\r\n",
          "ok");

  private static final List<String> NUMBERS =
      List.of(
          "0",
          "1",
          "20",
          "50",
          "100",
          "-100",
          "500",
          "-500",
          "360",
          "0.5",
          "35.234234",
          "-0",
          "NaN",
          "Infinity",
          "1e309",
          "0x10",
          "+5",
          ".5",
          "5.",
          "--1",
          "00050",
          "999999999999999",
          "1234567890123456",
          "-99999999999999",
          "\u00d9\u00a3",
          "1,5",
          "2147483648",
          "");

  private static final List<String> COMMANDS =
      List.of(
          "command",
          "takeoff",
          "land",
          "forward 50",
          "rc 10 -10 0 100",
          "go 100 0 0 50",
          "curve 25 -25 0 25 -75 0 20",
          "flip l",
          "cw 90",
          "speed 50",
          "battery?",
          "stop",
          "go 0 0 100 50 m1",
          "jump 0 0 100 50 90 m1 m2",
          "mdirection 2",
          "wifi a b",
          "EXT led 1 2 3",
          "EXT mled l r 1 hi",
          "port 8890 11111",
          "Re0101 forward 50");

  private final Random random;

  public GarbageSource(long seed) {
    this.random = new Random(seed);
  }

  /** Returns the next text, one character per byte. */
  public String next() {
    int kind = random.nextInt(100);
    if (kind < 20) {
      return bytes(random.nextInt(40));
    }
    if (kind < 45) {
      return sentence();
    }
    if (kind < 70) {
      return mutated(pick(COMMANDS));
    }
    if (kind < 85) {
      return truncated(pick(COMMANDS));
    }
    if (kind < 99) {
      return pick(COMMANDS);
    }
    return oversized();
  }

  private String pick(List<String> list) {
    return list.get(random.nextInt(list.size()));
  }

  private String bytes(int length) {
    StringBuilder text = new StringBuilder(length);
    for (int i = 0; i < length; i++) {
      text.append((char) random.nextInt(256));
    }
    return text.toString();
  }

  private String sentence() {
    StringBuilder text = new StringBuilder(pick(WORDS));
    int words = random.nextInt(9);
    for (int i = 0; i < words; i++) {
      text.append(random.nextInt(20) == 0 ? "" : " ");
      text.append(random.nextInt(5) == 0 ? pick(WORDS) : pick(NUMBERS));
    }
    return text.toString();
  }

  private String mutated(String command) {
    StringBuilder text = new StringBuilder(command);
    int changes = 1 + random.nextInt(3);
    for (int i = 0; i < changes; i++) {
      int at = random.nextInt(text.length());
      switch (random.nextInt(4)) {
        case 0 -> text.setCharAt(at, (char) random.nextInt(256));
        case 1 -> text.insert(at, (char) random.nextInt(256));
        case 2 -> text.insert(at, pick(NUMBERS));
        default -> text.append((char) random.nextInt(256));
      }
    }
    return text.toString();
  }

  private String truncated(String command) {
    int start = random.nextInt(4) == 0 ? random.nextInt(command.length()) : 0;
    return command.substring(start, start + random.nextInt(command.length() - start + 1));
  }

  private String oversized() {
    int length = 1000 + random.nextInt(1100);
    return switch (random.nextInt(4)) {
      case 0 -> bytes(length);
      case 1 -> " ".repeat(length);
      case 2 -> pick(COMMANDS) + "\0".repeat(length);
      default -> "forward " + "5".repeat(length);
    };
  }
}

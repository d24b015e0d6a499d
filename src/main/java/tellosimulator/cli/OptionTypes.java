package tellosimulator.cli;

import java.math.BigDecimal;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.command.OperatorRule;
import tellosimulator.fault.FaultParameter;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.recording.RecordingFile;
import tellosimulator.scenario.Quantity;
import tellosimulator.time.TimeFactor;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/** Parses the words of the command line. Each error is reported in one sentence. */
final class OptionTypes {

  private static final String NUMBER = "(-?[0-9]+(?:\\.[0-9]+)?)";

  /** Maximum number of flights at a time. Decided: those of the largest machines. */
  private static final int MOST_JOBS = 256;

  private OptionTypes() {}

  private static final String PORT = "a port from 1 to " + AddressPlan.HIGHEST_PORT;

  static Integer port(String word) {
    return wholeNumber(word, 1, AddressPlan.HIGHEST_PORT, PORT);
  }

  /** Parses one port for all drones, or one for each drone. */
  static List<Integer> portsOfDrones(String words) {
    return Stream.of(words.split(",", -1)).map(OptionTypes::port).toList();
  }

  static Integer portOrFree(String word) {
    return wholeNumber(word, 0, AddressPlan.HIGHEST_PORT, PORT + ", or 0 for a free one");
  }

  /** Parses the address of a board, which has the token of the class. */
  static URI boardAddress(String word) {
    if (!word.matches("https?://[^/?#\\s]+(/[^?#\\s]*)?\\?class=[0-9a-f]+")) {
      throw diagnostic("the address that the board has printed, http://…/?class=…", word);
    }
    return URI.create(word);
  }

  static OptionalInt replyPort(String word) {
    return word.equals("sender")
        ? OptionalInt.empty()
        : OptionalInt.of(wholeNumber(word, 1, AddressPlan.HIGHEST_PORT, "sender or " + PORT));
  }

  static Path fileOrFolder(String word) {
    try {
      if (!word.isEmpty()) {
        return Path.of(word);
      }
    } catch (InvalidPathException e) {
      // reported below
    }
    throw diagnostic("the name of a file or a folder", word);
  }

  /** Parses the folder of a recording. A file in the folder may be given instead. */
  static Path recording(String word) {
    return RecordingFile.folderOf(fileOrFolder(word));
  }

  /** Parses the name of an output file, which must not be part of a recording. */
  static Path outputFile(String word) {
    Path file = fileOrFolder(word);
    if (RecordingFile.belongsToRecording(file)) {
      throw new TypeConversionException(
          file + " is a file of a recording, which would be lost; name another file");
    }
    return file;
  }

  static Double fieldOfView(String word) {
    return word.equals("manual")
        ? Math.toDegrees(
            DroneOptics.horizontalFieldOfView(Math.toRadians(DroneOptics.MANUALS_DIAGONAL_DEG)))
        : degrees(word, DroneOptics.NARROWEST_DEG, DroneOptics.WIDEST_DEG);
  }

  static Double tilt(String word) {
    return degrees(word, -DroneOptics.STEEPEST_DEG, DroneOptics.STEEPEST_DEG);
  }

  static Integer photoWidth(String word) {
    int width =
        wholeNumber(
            word,
            DroneOptics.SMALLEST_PHOTO,
            DroneOptics.PHOTO_WIDTH,
            "an even number from " + DroneOptics.SMALLEST_PHOTO + " to " + DroneOptics.PHOTO_WIDTH);
    return width / 2 * 2;
  }

  static Integer droneCount(String word) {
    return wholeNumber(
        word, 1, AddressPlan.MOST_DRONES, "a number from 1 to " + AddressPlan.MOST_DRONES);
  }

  static Integer jobs(String word) {
    return wholeNumber(word, 1, MOST_JOBS, "a number from 1 to " + MOST_JOBS);
  }

  static Long seed(String word) {
    if (!word.matches("-?[0-9]{1,18}")) { // the same form as in scenario files
      throw diagnostic("a whole number of at most 18 digits", word);
    }
    return Long.valueOf(word);
  }

  private static final String EXPECTED = "an address of this machine such as 127.0.0.2";

  /** Parses one or more addresses, all different. */
  static List<InetAddress> addresses(String words) {
    List<InetAddress> addresses = new ArrayList<>();
    for (String word : words.split(",", -1)) {
      InetAddress address = address(word, EXPECTED);
      if (addresses.contains(address)) {
        throw new TypeConversionException(
            word + " is there twice, but each drone needs an address of its own");
      }
      addresses.add(address);
    }
    return addresses;
  }

  private static InetAddress address(String word, String expected) {
    return AddressPlan.parse(word).orElseThrow(() -> diagnostic(expected, word));
  }

  /** Parses one address of this machine. */
  static InetAddress ownAddress(String word) {
    return address(word, EXPECTED);
  }

  /** Parses the command address of a drone; the default port is the one that real drones use. */
  static InetSocketAddress droneAddress(String word) {
    String expected = "the address of a drone such as 192.168.10.1 or 192.168.10.1:8889";
    int colon = word.indexOf(':');
    InetAddress host = address(colon < 0 ? word : word.substring(0, colon), expected);
    int port =
        colon < 0
            ? AddressPlan.REAL_COMMAND_PORT
            : wholeNumber(word.substring(colon + 1), 1, AddressPlan.HIGHEST_PORT, expected);
    return new InetSocketAddress(host, port);
  }

  static OperatorRule operators(String word) {
    return switch (word) {
      case "first" -> OperatorRule.FIRST;
      case "anyone" -> OperatorRule.ANYONE;
      default ->
          OperatorRule.only(address(word, "first, anyone or an address such as 192.168.1.7"));
    };
  }

  private static final Pattern ROOM_SIZE_FORM =
      Pattern.compile(NUMBER + "x" + NUMBER + "x" + NUMBER);

  static Room roomSize(String word) {
    Matcher sizes =
        matched(ROOM_SIZE_FORM, word, "width, depth and height in cm such as 500x500x300");
    try {
      return new Room(meters(sizes, 1), meters(sizes, 2), meters(sizes, 3));
    } catch (IllegalArgumentException e) {
      throw diagnostic("width, depth and height " + range(Quantity.ROOM_EDGE) + " cm", word);
    }
  }

  private static final Pattern POSTER_ON_WALL_FORM =
      Pattern.compile("([a-z]+)," + NUMBER + "," + NUMBER + "," + NUMBER + ",(.+)");

  static Poster posterOnWall(String word) {
    Matcher parts =
        matched(
            POSTER_ON_WALL_FORM,
            word,
            "WALL,ALONG,HEIGHT,WIDTH,FILE such as front,0,120,30,face.png");
    Surface wall = Surface.byWord().get(parts.group(1));
    if (wall == null) {
      throw diagnostic("front, back, left, right, floor or ceiling", parts.group(1));
    }
    try {
      return new Poster(wall, meters(parts, 2), meters(parts, 3), meters(parts, 4), parts.group(5));
    } catch (IllegalArgumentException e) {
      throw diagnostic("a width " + range(Quantity.POSTER_WIDTH) + " cm", parts.group(4));
    }
  }

  private static final Pattern FLOOR_POINT_FORM = Pattern.compile(NUMBER + "," + NUMBER);

  /** Parses a point on the floor. */
  static Vec3 floorPoint(String word) {
    Matcher point = matched(FLOOR_POINT_FORM, word, "X,Y in cm such as 100,-50");
    return new Vec3(meters(point, 1), meters(point, 2), 0);
  }

  static TimeFactor factor(String word) {
    if (word.equals("max")) {
      return TimeFactor.MAX;
    }
    double factor = number(word);
    if (!Quantity.TIME_FACTOR.contains(factor)) {
      throw diagnostic("a number " + range(Quantity.TIME_FACTOR) + ", or max", word);
    }
    return new TimeFactor(factor);
  }

  static Double seconds(String word) {
    double seconds = FaultParameter.Unit.SECONDS.read(word).orElse(0.0);
    if (!(seconds > 0 && seconds <= Quantity.TIME_LIMIT.most())) {
      throw diagnostic(
          "a time such as 90 or 90s, of at most " + plain(Quantity.TIME_LIMIT.most()) + " s", word);
    }
    return seconds;
  }

  /** Parses a whole number without a sign. */
  private static int wholeNumber(String word, int least, int most, String expected) {
    int number = word.matches("[0-9]{1,9}") ? Integer.parseInt(word) : -1;
    if (number < least || number > most) {
      throw diagnostic(expected, word);
    }
    return number;
  }

  private static double degrees(String word, int least, int most) {
    double value = number(word);
    if (!(value >= least && value <= most)) {
      throw diagnostic("degrees from " + least + " to " + most, word);
    }
    return value;
  }

  private static double number(String word) {
    return word.matches(NUMBER) ? Double.parseDouble(word) : Double.NaN;
  }

  private static Matcher matched(Pattern form, String word, String expected) {
    Matcher matcher = form.matcher(word);
    if (!matcher.matches()) {
      throw diagnostic(expected, word);
    }
    return matcher;
  }

  private static TypeConversionException diagnostic(String expected, String word) {
    return new TypeConversionException(
        "expected " + expected + ", found " + (word.isEmpty() ? "nothing" : word));
  }

  private static double meters(Matcher sizes, int group) {
    return Frames.meters(Double.parseDouble(sizes.group(group)));
  }

  private static String range(Quantity quantity) {
    return "from " + bounds(quantity);
  }

  /**
   * Formats the range of a quantity in the unit in which users write it, such as {@code 100 to
   * 20000}.
   */
  static String bounds(Quantity quantity) {
    return plain(quantity.least()) + " to " + plain(quantity.most());
  }

  /** Formats a number without trailing zeros. */
  private static String plain(double number) {
    return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
  }

  /** Parses a word that must be the name of one of several values. */
  static <T> T byName(String word, T[] values, Function<T, String> name) {
    return Stream.of(values)
        .filter(value -> name.apply(value).equals(word))
        .findFirst()
        .orElseThrow(
            () ->
                diagnostic(
                    "one of " + Stream.of(values).map(name).collect(Collectors.joining(", ")),
                    word));
  }
}

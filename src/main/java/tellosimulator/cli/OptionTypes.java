package tellosimulator.cli;

import java.math.BigDecimal;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.command.OperatorRule;
import tellosimulator.export.ExportFormat;
import tellosimulator.fault.FaultParameter;
import tellosimulator.goal.Challenge;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.recording.RecordingFile;
import tellosimulator.time.TimeFactor;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

/** How words of the command line are read; each mistake is a sentence. */
final class OptionTypes {

  private static final String NUMBER = "(-?[0-9]+(?:\\.[0-9]+)?)";

  private OptionTypes() {}

  /** A place on the floor in centimetres. */
  record Point(double x, double y) {
    Vec3 inMeters() {
      return new Vec3(Frames.meters(x), Frames.meters(y), 0);
    }
  }

  /** One or more addresses, all different. */
  record AddressList(List<InetAddress> addresses) {}

  private static final String PORT = "a port from 1 to " + AddressPlan.HIGHEST_PORT;

  static Integer port(String word) {
    return wholeNumber(word, 1, AddressPlan.HIGHEST_PORT, PORT);
  }

  /** One port for all drones, or one for each. */
  record PortList(List<Integer> ports) {}

  static PortList portsOfDrones(String words) {
    List<Integer> ports = new ArrayList<>();
    for (String word : words.split(",", -1)) {
      ports.add(port(word));
    }
    return new PortList(List.copyOf(ports));
  }

  static Integer portOrFree(String word) {
    return wholeNumber(word, 0, AddressPlan.HIGHEST_PORT, PORT + ", or 0 for a free one");
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
      // told below
    }
    throw diagnostic("the name of a file or a folder", word);
  }

  /** The folder of a recording, which may be named by a file in it. */
  static Path recording(String word) {
    return RecordingFile.folderOf(fileOrFolder(word));
  }

  /** A file to be written, which must not be part of a recording. */
  static Path outputFile(String word) {
    Path file = fileOrFolder(word);
    if (RecordingFile.belongsToRecording(file)) {
      throw new TypeConversionException(
          file + " is a file of a recording, which would be lost; name another file");
    }
    return file;
  }

  static ExportFormat exportFormat(String word) {
    return byName(word, List.of(ExportFormat.values()), ExportFormat::word);
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

  static Integer droneCount(String word) {
    return wholeNumber(
        word, 1, AddressPlan.MOST_DRONES, "a number from 1 to " + AddressPlan.MOST_DRONES);
  }

  static Long seed(String word) {
    if (!word.matches("-?[0-9]{1,18}")) { // as in scenario files
      throw diagnostic("a whole number of at most 18 digits", word);
    }
    return Long.valueOf(word);
  }

  private static final Pattern ADDRESSES_FORM = Pattern.compile("[0-9]{1,3}(\\.[0-9]{1,3}){3}");
  private static final String EXPECTED = "an address of this machine such as 127.0.0.2";

  static AddressList addresses(String words) throws UnknownHostException {
    List<InetAddress> addresses = new ArrayList<>();
    for (String word : words.split(",", -1)) {
      InetAddress address = address(word, EXPECTED);
      if (addresses.contains(address)) {
        throw new TypeConversionException(
            word + " is there twice, but each drone needs an address of its own");
      }
      addresses.add(address);
    }
    return new AddressList(List.copyOf(addresses));
  }

  private static InetAddress address(String word, String expected) throws UnknownHostException {
    if (!ADDRESSES_FORM.matcher(word).matches()
        || Arrays.stream(word.split("\\.", -1)).anyMatch(part -> Integer.parseInt(part) > 255)) {
      throw diagnostic(expected, word);
    }
    InetAddress address = InetAddress.getByName(word);
    if (!AddressPlan.isOfOneHost(address)) {
      throw diagnostic(expected, word);
    }
    return address;
  }

  /** One address of this machine. */
  static InetAddress ownAddress(String word) throws UnknownHostException {
    return address(word, EXPECTED);
  }

  /** Where a drone takes commands; where it always does, unless a port is said. */
  static InetSocketAddress droneAddress(String word) throws UnknownHostException {
    String expected = "the address of a drone such as 192.168.10.1 or 192.168.10.1:8889";
    int colon = word.indexOf(':');
    InetAddress host = address(colon < 0 ? word : word.substring(0, colon), expected);
    int port =
        colon < 0
            ? AddressPlan.REAL_COMMAND_PORT
            : wholeNumber(word.substring(colon + 1), 1, AddressPlan.HIGHEST_PORT, expected);
    return new InetSocketAddress(host, port);
  }

  static OperatorRule operators(String word) throws UnknownHostException {
    return switch (word) {
      case "first" -> OperatorRule.FIRST;
      case "anyone" -> OperatorRule.ANYONE;
      default ->
          OperatorRule.only(address(word, "first, anyone or an address such as 192.168.1.7"));
    };
  }

  static Profile profileName(String word) {
    return byName(word, List.of(Profile.values()), Profile::option);
  }

  static Behavior behaviorName(String word) {
    return byName(word, List.of(Behavior.values()), Behavior::option);
  }

  static String logLevel(String word) {
    return byName(word, List.of("error", "warn", "info", "debug", "off"), Function.identity());
  }

  private static final Pattern ROOM_SIZE_FORM =
      Pattern.compile(NUMBER + "x" + NUMBER + "x" + NUMBER);

  static Room roomSize(String word) {
    Matcher sizes = ROOM_SIZE_FORM.matcher(word);
    if (!sizes.matches()) {
      throw diagnostic("width, depth and height in cm such as 500x500x300", word);
    }
    try {
      return new Room(meters(sizes, 1), meters(sizes, 2), meters(sizes, 3));
    } catch (IllegalArgumentException e) {
      throw diagnostic(
          "width, depth and height from "
              + centimeters(Room.SHORTEST)
              + " to "
              + centimeters(Room.LONGEST)
              + " cm",
          word);
    }
  }

  static Walls wallsName(String word) {
    return byName(word, List.of(Walls.values()), Walls::option);
  }

  private static final Pattern POSTER_ON_WALL_FORM =
      Pattern.compile("([a-z]+)," + NUMBER + "," + NUMBER + "," + NUMBER + ",(.+)");

  static Poster posterOnWall(String word) {
    Matcher parts = POSTER_ON_WALL_FORM.matcher(word);
    if (!parts.matches()) {
      throw diagnostic("WALL,ALONG,HEIGHT,WIDTH,FILE such as front,0,120,30,face.png", word);
    }
    Surface wall = Surface.byWord().get(parts.group(1));
    if (wall == null) {
      throw diagnostic("front, back, left, right, floor or ceiling", parts.group(1));
    }
    try {
      return new Poster(wall, meters(parts, 2), meters(parts, 3), meters(parts, 4), parts.group(5));
    } catch (IllegalArgumentException e) {
      throw diagnostic(
          "a width from "
              + centimeters(Poster.NARROWEST)
              + " to "
              + centimeters(Room.LONGEST)
              + " cm",
          parts.group(4));
    }
  }

  private static final Pattern FLOOR_POINT_FORM = Pattern.compile(NUMBER + "," + NUMBER);

  static Point floorPoint(String word) {
    Matcher point = FLOOR_POINT_FORM.matcher(word);
    if (!point.matches()) {
      throw diagnostic("X,Y in cm such as 100,-50", word);
    }
    return new Point(Double.parseDouble(point.group(1)), Double.parseDouble(point.group(2)));
  }

  static TimeFactor factor(String word) {
    if (word.equals("max")) {
      return TimeFactor.MAX;
    }
    try {
      return new TimeFactor(word.matches(NUMBER) ? Double.parseDouble(word) : Double.NaN);
    } catch (IllegalArgumentException e) {
      throw diagnostic(
          "a number from "
              + plain(TimeFactor.SMALLEST)
              + " to "
              + plain(TimeFactor.LARGEST)
              + ", or max",
          word);
    }
  }

  static Double seconds(String word) {
    double seconds = FaultParameter.Unit.SECONDS.read(word).orElse(0.0);
    if (!(seconds > 0 && seconds <= Challenge.LONGEST)) {
      throw diagnostic(
          "a time such as 90 or 90s, of at most " + plain(Challenge.LONGEST) + " s", word);
    }
    return seconds;
  }

  /** A whole number without sign. */
  private static int wholeNumber(String word, int least, int most, String expected) {
    int number = word.matches("[0-9]{1,9}") ? Integer.parseInt(word) : -1;
    if (number < least || number > most) {
      throw diagnostic(expected, word);
    }
    return number;
  }

  private static double degrees(String word, int least, int most) {
    double value = word.matches(NUMBER) ? Double.parseDouble(word) : Double.NaN;
    if (!(value >= least && value <= most)) {
      throw diagnostic("degrees from " + least + " to " + most, word);
    }
    return value;
  }

  private static TypeConversionException diagnostic(String expected, String word) {
    return new TypeConversionException(
        "expected " + expected + ", found " + (word.isEmpty() ? "nothing" : word));
  }

  private static double meters(Matcher sizes, int group) {
    return Frames.meters(Double.parseDouble(sizes.group(group)));
  }

  private static String centimeters(double meters) {
    return plain(Frames.centimeters(meters));
  }

  /** Without decimals that say nothing. */
  private static String plain(double number) {
    return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
  }

  private static <T> T byName(String word, List<T> values, Function<T, String> name) {
    return values.stream()
        .filter(value -> name.apply(value).equals(word))
        .findFirst()
        .orElseThrow(
            () ->
                diagnostic(
                    "one of " + values.stream().map(name).collect(Collectors.joining(", ")), word));
  }
}

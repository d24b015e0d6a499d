package tellosimulator;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behaviour;
import tellosimulator.profile.Profile;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Room;

/** How words of the command line are read; each mistake is a sentence. */
final class OptionTypes {

  private static final String NUMBER = "(-?[0-9]+(?:\\.[0-9]+)?)";

  private OptionTypes() {}

  /** A place on the floor in centimetres. */
  record Point(double x, double y) {
    Vec3 inMetres() {
      return new Vec3(Frames.metres(x), Frames.metres(y), 0);
    }
  }

  static final class ReplyPort implements ITypeConverter<OptionalInt> {
    @Override
    public OptionalInt convert(String word) {
      if (word.equals("sender")) {
        return OptionalInt.empty();
      }
      if (!word.matches("[0-9]{1,5}") || !isPort(Integer.parseInt(word))) {
        throw new TypeConversionException("expected sender or a port, found " + word);
      }
      return OptionalInt.of(Integer.parseInt(word));
    }

    private static boolean isPort(int number) {
      return number >= 1 && number <= 65535;
    }
  }

  static final class Address implements ITypeConverter<InetAddress> {
    private static final Pattern FORM = Pattern.compile("[0-9]{1,3}(\\.[0-9]{1,3}){3}");

    @Override
    public InetAddress convert(String word) throws UnknownHostException {
      if (!FORM.matcher(word).matches()
          || Arrays.stream(word.split("\\.", -1)).anyMatch(part -> Integer.parseInt(part) > 255)) {
        throw new TypeConversionException("expected an address such as 127.0.0.2, found " + word);
      }
      return InetAddress.getByName(word);
    }
  }

  static final class ProfileName implements ITypeConverter<Profile> {
    @Override
    public Profile convert(String word) {
      return byName(word, List.of(Profile.values()), Profile::option);
    }
  }

  static final class BehaviourName implements ITypeConverter<Behaviour> {
    @Override
    public Behaviour convert(String word) {
      return byName(word, List.of(Behaviour.values()), Behaviour::option);
    }
  }

  static final class LogLevel implements ITypeConverter<String> {
    @Override
    public String convert(String word) {
      return byName(word, List.of("error", "warn", "info", "debug", "off"), Function.identity());
    }
  }

  static final class RoomSize implements ITypeConverter<Room> {
    private static final Pattern FORM = Pattern.compile(NUMBER + "x" + NUMBER + "x" + NUMBER);

    @Override
    public Room convert(String word) {
      Matcher sizes = FORM.matcher(word);
      if (!sizes.matches()) {
        throw new TypeConversionException(
            "expected width, depth and height in cm such as 500x500x300, found " + word);
      }
      try {
        return new Room(metres(sizes, 1), metres(sizes, 2), metres(sizes, 3));
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(e.getMessage() + " m");
      }
    }
  }

  static final class FloorPoint implements ITypeConverter<Point> {
    private static final Pattern FORM = Pattern.compile(NUMBER + "," + NUMBER);

    @Override
    public Point convert(String word) {
      Matcher point = FORM.matcher(word);
      if (!point.matches()) {
        throw new TypeConversionException("expected X,Y in cm such as 100,-50, found " + word);
      }
      return new Point(Double.parseDouble(point.group(1)), Double.parseDouble(point.group(2)));
    }
  }

  static final class Factor implements ITypeConverter<TimeFactor> {
    @Override
    public TimeFactor convert(String word) {
      if (word.equals("max")) {
        return TimeFactor.MAX;
      }
      if (!word.matches(NUMBER)) {
        throw new TypeConversionException("expected a number or max, found " + word);
      }
      try {
        return new TimeFactor(Double.parseDouble(word));
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(e.getMessage());
      }
    }
  }

  private static double metres(Matcher sizes, int group) {
    return Frames.metres(Double.parseDouble(sizes.group(group)));
  }

  private static <T> T byName(String word, List<T> values, Function<T, String> name) {
    return values.stream()
        .filter(value -> name.apply(value).equals(word))
        .findFirst()
        .orElseThrow(
            () ->
                new TypeConversionException(
                    "expected one of "
                        + values.stream().map(name).collect(Collectors.joining(", "))
                        + ", found "
                        + word));
  }
}

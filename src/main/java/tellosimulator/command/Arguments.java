package tellosimulator.command;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import tellosimulator.controller.Direction;
import tellosimulator.controller.PadChoice;
import tellosimulator.extension.MatrixEffect;
import tellosimulator.extension.MatrixPicture;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/** The words after a command's verb, and their conversion to the values of a {@link Command}. */
record Arguments(List<String> words) {

  /** The flip directions, keyed by the letters in the SDK guide and by full words. */
  private static final Map<String, Direction> DIRECTIONS =
      new TreeMap<>(
          Map.of(
              "l", Direction.LEFT,
              "r", Direction.RIGHT,
              "f", Direction.FORWARD,
              "b", Direction.BACK,
              "left", Direction.LEFT,
              "right", Direction.RIGHT,
              "forward", Direction.FORWARD,
              "back", Direction.BACK));

  String word(int index) {
    return words.get(index);
  }

  double number(int index) {
    return Double.parseDouble(word(index));
  }

  int integer(int index) {
    return (int) number(index);
  }

  double meters(int index) {
    return Frames.meters(number(index));
  }

  /**
   * Converts the word at {@code index}, a heading in degrees clockwise, to radians
   * counter-clockwise.
   */
  double heading(int index) {
    return Frames.headingOfYaw(number(index));
  }

  /** Converts three words, starting at {@code index}, from centimetres to a point [m]. */
  Vec3 point(int index) {
    return new Vec3(meters(index), meters(index + 1), meters(index + 2));
  }

  PadChoice pad(int index) {
    return new PadChoice(Integer.parseInt(word(index).substring(1)));
  }

  /**
   * Converts three words, starting at {@code index}, to a colour 0xrrggbb. Each word is a number
   * from 0 to 255.
   */
  int rgb(int index) {
    return integer(index) << 16 | integer(index + 1) << 8 | integer(index + 2);
  }

  /** Returns the LED matrix colour that a word selects. */
  MatrixPicture.Color dotColor(int index) {
    return MatrixPicture.Color.of(word(index).charAt(0));
  }

  /** Returns the scrolling direction that a word selects. */
  MatrixEffect.Move move(int index) {
    return MatrixEffect.Move.of(word(index).charAt(0));
  }

  /**
   * Returns the picture that a word selects: a heart for {@code heart}, otherwise the word's first
   * character. Documented: SDK 3.0 User Guide.
   */
  MatrixPicture character(int index, MatrixPicture.Color color) {
    return word(index).equals("heart")
        ? MatrixPicture.heart(color)
        : MatrixPicture.ofCharacter(word(index).charAt(0), color);
  }

  /** Returns all words that name a flip direction. */
  static String[] flips() {
    return DIRECTIONS.keySet().toArray(String[]::new);
  }

  Direction flip(int index) {
    return DIRECTIONS.get(word(index));
  }

  /** Returns the frame rate that a word selects [frames/s]. Documented: SDK 3.0 User Guide. */
  int framesPerSecond(int index) {
    return switch (word(index)) {
      case "high" -> 30;
      case "middle" -> 15;
      default -> 5;
    };
  }

  /** Returns the frame height that a word selects [lines]. Documented: SDK 3.0 User Guide. */
  int lines(int index) {
    return word(index).equals("high") ? 720 : 480;
  }
}

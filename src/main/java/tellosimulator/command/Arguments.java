package tellosimulator.command;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import tellosimulator.board.MatrixEffect;
import tellosimulator.board.MatrixPicture;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/** The words after a verb, read as what the command's parameters say. */
record Arguments(List<String> words) {

  /** Directions of a flip: the guide's letters, and the words in full. */
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

  /** Radians counter-clockwise of degrees clockwise. */
  double heading(int index) {
    return Frames.headingOfYaw(number(index));
  }

  /** Three words in centimetres from {@code index} on [m]. */
  Vec3 point(int index) {
    return new Vec3(meters(index), meters(index + 1), meters(index + 2));
  }

  PadChoice pad(int index) {
    return new PadChoice(Integer.parseInt(word(index).substring(1)));
  }

  /** Three words for red, green and blue from {@code index} on, as one writes #rrggbb. */
  int rgb(int index) {
    return integer(index) << 16 | integer(index + 1) << 8 | integer(index + 2);
  }

  /** The colour of dots. */
  MatrixPicture.Color dotColor(int index) {
    return MatrixPicture.Color.of(word(index).charAt(0));
  }

  /** Where a text moves. */
  MatrixEffect.Move move(int index) {
    return MatrixEffect.Move.of(word(index).charAt(0));
  }

  /** A heart, or the first character of a word. Documented: SDK 3.0 User Guide. */
  MatrixPicture character(int index, MatrixPicture.Color color) {
    return word(index).equals("heart")
        ? MatrixPicture.heart(color)
        : MatrixPicture.ofCharacter(word(index).charAt(0), color);
  }

  /** All words for the direction of a flip. */
  static String[] flips() {
    return DIRECTIONS.keySet().toArray(String[]::new);
  }

  Direction flip(int index) {
    return DIRECTIONS.get(word(index));
  }

  /** Pictures a second. Documented: SDK 3.0 User Guide. */
  int framesPerSecond(int index) {
    return switch (word(index)) {
      case "high" -> 30;
      case "middle" -> 15;
      default -> 5;
    };
  }

  /** Lines of a picture. Documented: SDK 3.0 User Guide. */
  int lines(int index) {
    return word(index).equals("high") ? 720 : 480;
  }
}

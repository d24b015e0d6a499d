package tellosimulator.command;

import java.util.Map;
import java.util.TreeMap;

/** The words for the direction of a flip: the guide's letters, and the words in full. */
final class FlipWords {

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

  private FlipWords() {}

  static String[] all() {
    return DIRECTIONS.keySet().toArray(String[]::new);
  }

  static Direction direction(String word) {
    return DIRECTIONS.get(word);
  }
}

package tellosimulator.world;

import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.words.Phrase;

/** A side of the room. */
public enum Surface implements Collidable {
  FLOOR("floor", Phrase.of("the floor")),
  CEILING("ceiling", Phrase.of("the ceiling")),
  FRONT_WALL("front", Phrase.of("the front wall")),
  BACK_WALL("back", Phrase.of("the back wall")),
  LEFT_WALL("left", Phrase.of("the left wall")),
  RIGHT_WALL("right", Phrase.of("the right wall"));

  private final String word;
  private final Phrase phrase;

  Surface(String word, Phrase phrase) {
    this.word = word;
    this.phrase = phrase;
  }

  /** All of them by their names in files and on the command line: {@code front}. */
  public static Map<String, Surface> byWord() {
    return Stream.of(values())
        .collect(Collectors.toUnmodifiableMap(side -> side.word, side -> side));
  }

  @Override
  public Phrase phrase() {
    return phrase;
  }

  /** Whether it stands upright. */
  public boolean wall() {
    return this != FLOOR && this != CEILING;
  }

  /** Where somebody in the room's middle looks who looks at this wall [rad], 0 along x. */
  public double heading() {
    return switch (this) {
      case LEFT_WALL -> Math.PI / 2;
      case BACK_WALL -> Math.PI;
      case RIGHT_WALL -> -Math.PI / 2;
      default -> 0;
    };
  }
}

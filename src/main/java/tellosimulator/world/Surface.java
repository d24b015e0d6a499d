package tellosimulator.world;

import tellosimulator.words.Phrase;

/** A side of the room. */
public enum Surface implements Touchable {
  FLOOR(Phrase.of("the floor")),
  CEILING(Phrase.of("the ceiling")),
  FRONT_WALL(Phrase.of("the front wall")),
  BACK_WALL(Phrase.of("the back wall")),
  LEFT_WALL(Phrase.of("the left wall")),
  RIGHT_WALL(Phrase.of("the right wall"));

  private final Phrase phrase;

  Surface(Phrase phrase) {
    this.phrase = phrase;
  }

  @Override
  public Phrase phrase() {
    return phrase;
  }

  /** Whether it stands upright. */
  public boolean wall() {
    return this != FLOOR && this != CEILING;
  }
}

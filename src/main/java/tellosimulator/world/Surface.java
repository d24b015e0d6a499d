package tellosimulator.world;

import tellosimulator.words.Phrase;

/** What a drone can run into. */
public enum Surface {
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

  /** For people. */
  public Phrase phrase() {
    return phrase;
  }
}

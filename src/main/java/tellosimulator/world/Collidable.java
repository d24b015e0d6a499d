package tellosimulator.world;

import tellosimulator.words.Phrase;

/** What a drone can run into. Immutable; for any thread. */
public sealed interface Collidable permits Surface, Obstacle, Collidable.OtherDrone {

  /** For people: {@code the front wall}. */
  Phrase phrase();

  /** Whether a drone can stand on it. */
  default boolean carries() {
    return true;
  }

  /**
   * Another drone, on which none can stand.
   *
   * @param number from 1
   */
  record OtherDrone(int number) implements Collidable {
    @Override
    public Phrase phrase() {
      return Phrase.of("drone %d", number);
    }

    @Override
    public boolean carries() {
      return false;
    }
  }
}

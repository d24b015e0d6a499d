package tellosimulator.world;

import tellosimulator.words.Phrase;

/** An object with which a drone can collide. Immutable. */
public sealed interface Collidable permits Surface, Obstacle, Collidable.OtherDrone {

  /** Returns a description of the object, such as {@code the front wall}. */
  Phrase phrase();

  /** Whether a drone can stand on the object. */
  default boolean carries() {
    return true;
  }

  /**
   * Another drone. No drone can stand on it.
   *
   * @param number the number of the other drone, from 1
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

package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.Collidable;
import tellosimulator.world.Obstacle;

/** Something that happened to a drone, other than a command or a reply. */
public sealed interface FlightEvent {

  /** For people: a clause about the drone, such as {@code took off}. */
  Phrase phrase();

  /** It left the ground. */
  record TookOff() implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("took off");
    }
  }

  /**
   * It stands on something with its motors off.
   *
   * @param on what it stands on
   */
  record Landed(Collidable on) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return on instanceof Obstacle obstacle
          ? Phrase.of("landed on \"%s\"", obstacle.label())
          : Phrase.of("landed");
    }
  }

  /**
   * It lands by itself.
   *
   * @param reason why, in plain words
   * @param silence whether because no command came
   */
  record LandsByItself(Phrase reason, boolean silence) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("lands by itself: %s", reason);
    }
  }

  /** A command ended a safety landing. */
  record LandingCanceled() implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("stays in the air, because a command arrived during the safety landing");
    }
  }

  /**
   * Its motors stopped in the air.
   *
   * @param reason why, in plain words
   */
  record Fell(Phrase reason) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("falls: %s", reason);
    }
  }

  /**
   * It hit something too hard.
   *
   * @param touched what it hit
   * @param speed how fast [m/s]
   * @param fallen how deep it had fallen [m]; 0 if its motors carried it
   * @param position where, room frame [m]
   */
  record Crashed(Collidable touched, double speed, double fallen, Vec3 position)
      implements FlightEvent {
    @Override
    public Phrase phrase() {
      return fallen > 0
          ? Phrase.of(
              "crashed into %s at %.1f m/s after a fall of %.1f m; its motors stay off until reset"
                  + " or power cycle",
              touched.phrase(), speed, fallen)
          : Phrase.of(
              "crashed into %s at %.1f m/s; its motors stay off until reset or power cycle",
              touched.phrase(), speed);
    }
  }

  /**
   * Its fall ended without harm.
   *
   * @param touched what it fell on
   * @param speed how fast it hit it [m/s]
   * @param fallen how deep it fell [m]
   */
  record Dropped(Collidable touched, double speed, double fallen) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("fell %.1f m and hit %s at %.1f m/s", fallen, touched.phrase(), speed);
    }
  }

  /**
   * It began to touch something, and goes on flying; {@link Parted} ends that.
   *
   * @param touched what it touched; not what it stands on
   * @param speed how fast [m/s]
   * @param position where, room frame [m]
   */
  record Touched(Collidable touched, double speed, Vec3 position) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("touched %s at %.1f m/s", touched.phrase(), speed);
    }
  }

  /**
   * It does not touch something any more.
   *
   * @param seconds since it began to touch it
   */
  record Parted(Collidable touched, double seconds) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("does not touch %s any more, after %.1f s", touched.phrase(), seconds);
    }
  }

  /** A person put it back to its start. */
  record PutBack() implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("was put back to its start");
    }
  }

  /**
   * Something was set or switched.
   *
   * @param phrase what, as a clause about the drone
   */
  record Note(Phrase phrase) implements FlightEvent {}
}

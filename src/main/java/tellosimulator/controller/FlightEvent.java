package tellosimulator.controller;

import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.Collidable;
import tellosimulator.world.Obstacle;

/** An event of a drone's flight, other than a command or a reply. */
public sealed interface FlightEvent {

  /** Returns a description that lacks its subject, the drone, such as {@code took off}. */
  Phrase phrase();

  /** The drone left the ground. */
  record TookOff() implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("took off");
    }
  }

  /**
   * The drone has landed: it stands on something with its motors off.
   *
   * @param on the object on which the drone stands
   */
  record Landed(Collidable on) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return on instanceof Obstacle obstacle
          ? Phrase.of("landed on \"%s\"", obstacle.label())
          : Phrase.of("landed");
    }
  }

  /** The kinds of reasons why a drone lands without a command. */
  enum LandingCause {
    SILENCE,
    BATTERY,
    FAULT,

    /** The program that flew the drone has ended. */
    END_OF_PROGRAM
  }

  /**
   * The drone begins to land automatically.
   *
   * @param reason the reason, in plain words
   * @param cause the kind of reason
   */
  record LandsByItself(Phrase reason, LandingCause cause) implements FlightEvent {
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
   * The drone's motors stopped in the air.
   *
   * @param reason the reason, in plain words
   */
  record Fell(Phrase reason) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("falls: %s", reason);
    }
  }

  /**
   * The drone hit something so hard that it crashed.
   *
   * @param touched the object that the drone hit
   * @param speed the impact speed [m/s]
   * @param fallen the depth of the fall [m]; 0 unless a fall ended on the ground
   * @param position the position of the drone, in the room frame [m]
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
   * The drone's fall ended without damage.
   *
   * @param touched the object onto which the drone fell
   * @param speed the impact speed [m/s]
   * @param fallen the depth of the fall [m]
   */
  record Dropped(Collidable touched, double speed, double fallen) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("fell %.1f m and hit %s at %.1f m/s", fallen, touched.phrase(), speed);
    }
  }

  /**
   * The drone began to touch something, and is still flying. The contact lasts until {@link
   * Parted}.
   *
   * @param touched the touched object, never the ground below the drone
   * @param speed the speed at which the drone hit the object [m/s]
   * @param position the position of the drone, in the room frame [m]
   */
  record Touched(Collidable touched, double speed, Vec3 position) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("touched %s at %.1f m/s", touched.phrase(), speed);
    }
  }

  /**
   * The drone no longer touches an object.
   *
   * @param seconds the duration of the contact
   */
  record Parted(Collidable touched, double seconds) implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("does not touch %s any more, after %.1f s", touched.phrase(), seconds);
    }
  }

  /** A reset put the drone back at its start. */
  record PutBack() implements FlightEvent {
    @Override
    public Phrase phrase() {
      return Phrase.of("was put back to its start");
    }
  }

  /**
   * Something else worth noting happened, such as a changed setting.
   *
   * @param phrase a clause about the drone
   */
  record Note(Phrase phrase) implements FlightEvent {}
}

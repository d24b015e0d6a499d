package tellosimulator.recording;

import java.net.InetSocketAddress;
import java.util.Optional;
import tellosimulator.command.WireText;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Progress;
import tellosimulator.math.Vec3;
import tellosimulator.network.WireTap;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.time.WallTime;

/** An entry that waits until the writer's thread writes it to a recording. Immutable. */
sealed interface Entry {

  /** Approximate memory that the entry takes in the queue [units of 300 bytes]. */
  default int weight() {
    return 1;
  }

  /**
   * The beginning of a flight.
   *
   * @param time the simulated time of the beginning
   * @param snapshot the state at that time; empty for a real drone, whose state is unknown
   */
  record Begin(WallTime wall, SimTime time, Optional<SimSnapshot> snapshot) implements Entry {

    /** Creates the first entry of a simulated flight. */
    Begin(WallTime wall, SimSnapshot snapshot) {
      this(wall, snapshot.time(), Optional.of(snapshot));
    }
  }

  /**
   * The end of a flight.
   *
   * @param time the simulated time of the end
   * @param progress the result of the goals
   * @param attemptNanos the start of the attempt, from which the progress counts its seconds
   *     [simulated ns]
   */
  record End(SimTime time, Progress progress, long attemptNanos) implements Entry {

    /** The word for the result in a recording. */
    String word() {
      if (progress.challenge().goals().isEmpty()) {
        return "none";
      }
      return switch (progress.status()) {
        case REACHED -> "reached";
        case FAILED -> "missed";
        case RUNNING -> "open";
      };
    }
  }

  /** Marks that the queue overflowed: no entries follow, and the recording ends here. */
  record Overrun() implements Entry {

    @Override
    public int weight() {
      return 0;
    }
  }

  /**
   * Marks the beginning of another run; earlier entries belong to the previous one.
   *
   * @param start the initial conditions of the new run; empty if unknown
   */
  record NewRun(Optional<InitialConditions> start) implements Entry {}

  /** A new challenge for the drones, set while all of them are on the ground. */
  record Asked(Challenge challenge) implements Entry {}

  /** Marks that some inputs were not recorded. */
  record Missed() implements Entry {}

  /**
   * An input of the simulation, or a command that was forwarded to a real drone.
   *
   * @param nanos the time on the clock of {@link WallTime#nanoTime}
   */
  record Input(SimTime time, long nanos, SimInput input) implements Entry {}

  /** A sample of the state of all drones. */
  record Sampled(SimSnapshot snapshot) implements Entry {

    @Override
    public int weight() {
      return snapshot.drones().size();
    }
  }

  /**
   * A simulation event.
   *
   * @param place the drone's position at that time, in the room frame [m]; empty if the event
   *     concerns all drones
   */
  record Happened(SimEvent event, Optional<Vec3> place) implements Entry {}

  /**
   * A sent datagram.
   *
   * @param nanos the time on the clock of {@link WallTime#nanoTime}
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared, and the bytes are never modified
  record Sent(SimTime time, long nanos, int drone, WireTap.Kind kind, Ends ends, byte[] bytes)
      implements Entry {

    /** Size of one unit of weight [bytes]. */
    private static final int UNIT = 300;

    @Override
    public int weight() {
      return 1 + bytes.length / UNIT;
    }

    boolean isVideo() {
      return kind == WireTap.Kind.VIDEO;
    }

    /** Returns the payload as a text, one character for each byte. */
    String text() {
      return WireText.decode(bytes);
    }
  }

  /** The source and destination of a sent datagram. */
  record Ends(InetSocketAddress from, InetSocketAddress to) {}
}

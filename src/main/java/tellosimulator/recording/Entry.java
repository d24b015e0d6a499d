package tellosimulator.recording;

import java.net.InetSocketAddress;
import java.util.Optional;
import tellosimulator.goal.Challenge;
import tellosimulator.math.Vec3;
import tellosimulator.network.WireTap;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.time.WallTime;

/** What is to be recorded, on its way to the thread that writes it. Immutable. */
sealed interface Entry {

  /** About how much of the queue it takes [300 bytes]. */
  default int weight() {
    return 1;
  }

  /**
   * A flight begins.
   *
   * @param time when
   * @param snapshot how things are then; empty of a real drone, of which nobody knows it
   */
  record Begin(WallTime wall, SimTime time, Optional<SimSnapshot> snapshot) implements Entry {

    /** That of a simulation. */
    Begin(WallTime wall, SimSnapshot snapshot) {
      this(wall, snapshot.time(), Optional.of(snapshot));
    }
  }

  /**
   * A flight is over.
   *
   * @param time when
   * @param goals what became of them
   */
  record End(SimTime time, GoalResult goals) implements Entry {}

  /** What came before is not recorded any more, because too much waited. */
  record Overrun() implements Entry {}

  /**
   * What came before belongs to another simulation.
   *
   * @param start what the one began from that follows; empty if that is not known
   */
  record Anew(Optional<InitialConditions> start) implements Entry {}

  /** Something else is asked of the drones, all of which are on the ground. */
  record Asked(Challenge challenge) implements Entry {}

  /** There were inputs that are not known. */
  record Missed() implements Entry {}

  /** An input that is no datagram. */
  record Taken(SimTime time, SimInput input) implements Entry {}

  /** How all drones are at a moment. */
  record Sampled(SimSnapshot snapshot) implements Entry {

    @Override
    public int weight() {
      return snapshot.drones().size();
    }
  }

  /**
   * Something happened.
   *
   * @param place where the drone was then, room frame [m]; empty if it concerns all
   */
  record Happened(SimEvent event, Optional<Vec3> place) implements Entry {}

  /**
   * A datagram that came.
   *
   * @param nanos on the clock of {@link WallTime#nanoTime}
   */
  record Received(SimTime time, long nanos, int drone, Ends ends, String text) implements Entry {}

  /**
   * A datagram that left.
   *
   * @param nanos on the clock of {@link WallTime#nanoTime}
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared, and nobody changes the bytes
  record Sent(SimTime time, long nanos, int drone, WireTap.Kind kind, Ends ends, byte[] bytes)
      implements Entry {

    /** Bytes of a unit of weight. */
    private static final int UNIT = 300;

    @Override
    public int weight() {
      return 1 + bytes.length / UNIT;
    }
  }

  /** Where a datagram came from, and where it went. */
  record Ends(InetSocketAddress from, InetSocketAddress to) {}
}

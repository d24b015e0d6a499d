package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;

/** The path of a drone's current flight, and the paths of its previous flights. Not thread-safe. */
final class FlightPaths {

  /**
   * Number of previous flights that are kept. Decided: people compare a flight only with their most
   * recent attempts.
   */
  static final int EARLIER = 3;

  /**
   * Opacity of the path of the previous flight. Decided: clearly less than the opacity of the
   * current flight's path.
   */
  private static final double FAINT = 0.4;

  /**
   * Factor by which the opacity decreases from each flight to the one before it. Decided: the
   * oldest path is barely visible.
   */
  private static final double FADING = 0.55;

  private final int capacity;
  private final List<FlightPath> earlier = new ArrayList<>();
  private FlightPath present;
  private boolean wasTakingOff;
  private int changes;

  /**
   * Creates an empty path for the current flight.
   *
   * @param capacity maximum number of points in a path, at least 4
   */
  FlightPaths(int capacity) {
    this.capacity = capacity;
    present = new FlightPath(capacity);
  }

  /**
   * Returns the opacity of a previous flight's path.
   *
   * @param age 1 for the most recent of the previous flights
   */
  static double opacity(int age) {
    return FAINT * StrictMath.pow(FADING, age - 1);
  }

  /**
   * Extends the current path. A new flight begins when the drone takes off.
   *
   * @param takingOff whether the drone is taking off. Being on the ground does not mark a new
   *     flight, because it may last for less than a frame
   * @param point position of the drone
   * @return whether the current path has changed
   */
  boolean advance(boolean takingOff, Vec3 point) {
    if (takingOff && !wasTakingOff && present.size() > 1) {
      earlier.add(0, present);
      if (earlier.size() > EARLIER) {
        earlier.remove(EARLIER);
      }
      present = new FlightPath(capacity);
      changes++;
    }
    wasTakingOff = takingOff;
    return present.add(point);
  }

  /** Removes all flights. */
  void clear() {
    present.clear();
    earlier.clear();
    wasTakingOff = false;
    changes++;
  }

  FlightPath present() {
    return present;
  }

  /** Returns the paths of the previous flights, in order from the most recent to the oldest. */
  List<FlightPath> earlier() {
    return List.copyOf(earlier);
  }

  /** Returns a counter that changes whenever the paths of the previous flights change. */
  int changes() {
    return changes;
  }
}

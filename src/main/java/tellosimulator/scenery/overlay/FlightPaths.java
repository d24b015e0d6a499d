package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;

/** The path of a drone's present flight, and the paths of the flights before it. For one thread. */
final class FlightPaths {

  /** Earlier flights that are kept. Decided: one compares with the last tries, not with all. */
  static final int EARLIER = 3;

  /** Opacity of the last flight's path. Decided: clearly behind the present one. */
  private static final double FAINT = 0.4;

  /** Opacity by that of the flight after it. Decided: the oldest can just be seen. */
  private static final double FADING = 0.55;

  private final int capacity;
  private final List<FlightPath> earlier = new ArrayList<>();
  private FlightPath present;
  private boolean wasTakingOff;
  private int changes;

  /**
   * @param capacity most points of a path, at least 4
   */
  FlightPaths(int capacity) {
    this.capacity = capacity;
    present = new FlightPath(capacity);
  }

  /**
   * How much the path of an earlier flight hides of what is behind it.
   *
   * @param age 1 for the last flight
   */
  static double opacity(int age) {
    return FAINT * StrictMath.pow(FADING, age - 1);
  }

  /**
   * Goes on with the drone; a new flight begins when it takes off.
   *
   * @param takingOff whether it takes off; on the ground it may be for less than a frame
   * @param point where it is
   * @return whether the present path has changed
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

  /** Forgets all flights. */
  void clear() {
    present.clear();
    earlier.clear();
    wasTakingOff = false;
    changes++;
  }

  FlightPath present() {
    return present;
  }

  /** The newest first. */
  List<FlightPath> earlier() {
    return List.copyOf(earlier);
  }

  /** A number that is another one when the earlier paths are. */
  int changes() {
    return changes;
  }
}

package tellosimulator.command;

import java.util.Optional;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.FaultParameter;
import tellosimulator.fault.LinkDirection;
import tellosimulator.model.DroneState;
import tellosimulator.sensor.SeededNoise.Channel;
import tellosimulator.time.Periodic;
import tellosimulator.time.SimTime;

/**
 * Sends a drone's state lines to its operator, as far as faults permit, and tracks whether the
 * operator is waiting for one. Confined to the simulation thread.
 */
final class StateLines {

  /** Mean period of state lines [s]. Measured on a real drone. */
  private static final double MEASURED_PERIOD = 0.1006;

  /** Standard deviation of the period of state lines [s]. Measured on a real drone. */
  private static final double PERIOD_DEVIATION = 0.011;

  /** Minimum period of state lines [s]. Measured on a real drone. */
  private static final double SHORTEST_PERIOD = 0.045;

  /** Maximum period of state lines [s]. Measured on a real drone. */
  private static final double LONGEST_PERIOD = 0.153;

  /** Period of state lines in behaviours without noise [s]. Report. */
  private static final double PERIOD = 0.1;

  private final ProtocolContext drone;
  private Optional<Periodic> lines = Optional.empty();
  private boolean owed;
  private long count;

  /** The last line that was sent, for the fault that repeats it. */
  private Optional<String> last = Optional.empty();

  private SimTime sent = SimTime.ZERO;

  StateLines(ProtocolContext drone) {
    this.drone = drone;
  }

  /** Schedules the first line for now, unless the schedule has already begun. */
  void begin() {
    if (lines.isEmpty()) {
      lines = Optional.of(new Periodic(drone.now(), this::period));
    }
  }

  /** Ends the schedule. */
  void end() {
    lines = Optional.empty();
    owed = false;
  }

  /** Records that a command has arrived, so that the operator is now waiting for the next line. */
  void owe() {
    owed = lines.isPresent();
  }

  /** Whether a command has arrived since the last line. */
  boolean hasPending() {
    return owed;
  }

  /** Sends the line that is due at the end of this step, if any. */
  void send() {
    if (lines.isEmpty() || !lines.get().due(drone.now())) {
      return;
    }
    boolean expected = owed;
    owed = false;
    OperatorSession session = drone.session();
    ActiveFaults faults = drone.faults().get();
    if (session.wantsState(drone.now()) && !suppressed(faults)) {
      sent = drone.now();
      boolean stuck = faults.find(FaultKind.STATE_STUCK).isPresent();
      last = Optional.of(stuck ? last.orElseGet(this::line) : line());
      Peer peer = session.link().at(session.link().statePort()).orElseThrow();
      byte[] bytes = WireText.encode(last.get());
      drone.port().send(new LinkDatagram(LinkDirection.STATE, peer, bytes, expected));
    }
  }

  private boolean suppressed(ActiveFaults faults) {
    double silence = drone.now().since(sent);
    return faults.find(FaultKind.STATE_STOPPED).isPresent()
        || faults
            .find(FaultKind.STATE_SLOW)
            .filter(slow -> silence < slow.value(FaultParameter.EVERY) - SimTime.STEP)
            .isPresent();
  }

  private String line() {
    DroneState state = drone.state().get();
    return StateLine.format(
        drone.profile(), state.perception().reading(), drone.instruments().read(state));
  }

  private double period() {
    if (!drone.behavior().noisySensors()) {
      return PERIOD;
    }
    double period =
        MEASURED_PERIOD + PERIOD_DEVIATION * drone.noise().gaussian(Channel.STATE_PERIOD, count++);
    return Math.max(SHORTEST_PERIOD, Math.min(LONGEST_PERIOD, period));
  }
}

package tellosimulator.command;

import tellosimulator.controller.Direction;
import tellosimulator.controller.PadChoice;
import tellosimulator.controller.Sticks;
import tellosimulator.extension.LightOrder;
import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.model.VideoOption;

/**
 * A parsed command with valid parameters. Unless a component documents otherwise, units are SI, and
 * axes are those of the level body frame: x along the nose, y to the left, z up.
 */
public sealed interface Command {

  /** {@code command}. */
  record EnterSdkMode() implements Command {}

  /** {@code takeoff} and {@code throwfly}. */
  record Takeoff() implements Command {}

  /** {@code land}. */
  record Land() implements Command {}

  /** {@code stop}. */
  record Stop() implements Command {}

  /** {@code emergency}. */
  record Emergency() implements Command {}

  /**
   * {@code up}, {@code down}, {@code left}, {@code right}, {@code forward} and {@code back}.
   *
   * @param distance the distance [m]
   */
  record Move(Direction direction, double distance) implements Command {}

  /**
   * {@code cw} and {@code ccw}.
   *
   * @param angle the angle [rad], counter-clockwise seen from above; can exceed a full turn
   */
  record Turn(double angle) implements Command {}

  /**
   * {@code flip}.
   *
   * @param direction any direction except up and down
   */
  record Flip(Direction direction) implements Command {}

  /**
   * {@code go}.
   *
   * @param way the displacement to the goal [m]
   * @param speed the speed [m/s]
   */
  record Go(Vec3 way, double speed) implements Command {}

  /**
   * {@code curve}.
   *
   * @param arc the arc relative to the current position [m]
   * @param speed the speed [m/s]
   */
  record Curve(Arc arc, double speed) implements Command {}

  /**
   * {@code go} with a mission pad.
   *
   * @param goal the goal in the pad's frame [m]
   * @param speed the speed [m/s]
   */
  record GoToPad(Vec3 goal, double speed, PadChoice pad) implements Command {}

  /**
   * {@code curve} with a mission pad.
   *
   * @param via the first point of the arc in the pad's frame [m]
   * @param end the second point of the arc in the pad's frame [m]
   * @param speed the speed [m/s]
   */
  record CurveOverPad(Vec3 via, Vec3 end, double speed, PadChoice pad) implements Command {}

  /**
   * {@code jump}.
   *
   * @param leg the first pad, the goal over it, and the speed
   * @param heading the heading at the end, in the second pad's frame [rad], counter-clockwise
   */
  record Jump(GoToPad leg, double heading, PadChoice second) implements Command {}

  /**
   * {@code speed}.
   *
   * @param speed the speed [m/s]
   */
  record SetSpeed(double speed) implements Command {}

  /** {@code rc}. */
  record Rc(Sticks sticks) implements Command {}

  /**
   * {@code wifi}, {@code ap} and {@code wifisetchannel}. The simulated drone joins no network, but
   * it may reboot as a real one does.
   *
   * @param done the reply if the drone reboots
   */
  record SetNetwork(Reply done) implements Command {}

  /** {@code mon} and {@code moff}. */
  record DetectPads(boolean on) implements Command {}

  /**
   * Selects the cameras that detect pads (the command "mdirection").
   *
   * @param direction 0 downward, 1 forward, 2 both
   */
  record SetPadDirection(int direction) implements Command {}

  /** {@code streamon} and {@code streamoff}. */
  record Stream(boolean on) implements Command {}

  /**
   * {@code setfps}, {@code setbitrate}, {@code setresolution} and {@code downvision}.
   *
   * @param value the value, in the unit of the option
   */
  record SetVideo(VideoOption option, int value) implements Command {}

  /** {@code port}. */
  record SetPorts(int statePort, int videoPort) implements Command {}

  /** {@code motoron} and {@code motoroff}. */
  record SpinMotors(boolean on) implements Command {}

  /** {@code reboot}. */
  record Reboot() implements Command {}

  /** {@code EXT led} and {@code EXT mled}. */
  record Light(LightOrder order, Reply reply) implements Command {}

  /** A command that the drone only acknowledges, such as {@code keepalive}. */
  record Acknowledge(Reply reply) implements Command {}

  /** Any command that ends with a question mark. */
  record Read(Reading reading) implements Command {}
}

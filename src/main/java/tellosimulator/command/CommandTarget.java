package tellosimulator.command;

import java.util.Optional;
import tellosimulator.words.Phrase;

/**
 * What carries commands out: one method a kind of command. Called on the simulation thread. Each
 * method answers through the responder, at once, later, or as the drone does: never.
 */
public interface CommandTarget {

  /** What is being carried out and how far it is, in plain words; empty if nothing is. */
  Optional<Phrase> running();

  /** Whether the motors carry the drone, so that it can move. */
  boolean flying();

  /** Why it does not fly, and what to do; only while it does not. */
  Phrase notFlying();

  /** Why it carries out nothing but {@code command}; empty if it does. */
  default Optional<Phrase> unactivated() {
    return Optional.empty();
  }

  /** Something arrived, whatever it was: the link is alive. */
  void linkAlive();

  /** A known command arrived: a safety landing ends. */
  void commandArrived();

  void enterSdkMode(Command.EnterSdkMode command, Responder responder);

  void takeoff(Command.Takeoff command, Responder responder);

  void land(Command.Land command, Responder responder);

  void stop(Command.Stop command, Responder responder);

  void emergency(Command.Emergency command, Responder responder);

  void move(Command.Move command, Responder responder);

  void turn(Command.Turn command, Responder responder);

  void flip(Command.Flip command, Responder responder);

  void go(Command.Go command, Responder responder);

  void curve(Command.Curve command, Responder responder);

  void goToPad(Command.GoToPad command, Responder responder);

  void curveOverPad(Command.CurveOverPad command, Responder responder);

  void jump(Command.Jump command, Responder responder);

  void setSpeed(Command.SetSpeed command, Responder responder);

  void rc(Command.Rc command, Responder responder);

  void setNetwork(Command.SetNetwork command, Responder responder);

  void detectPads(Command.DetectPads command, Responder responder);

  void setPadDirection(Command.SetPadDirection command, Responder responder);

  void stream(Command.Stream command, Responder responder);

  void setVideo(Command.SetVideo command, Responder responder);

  void setPorts(Command.SetPorts command, Responder responder);

  void spinMotors(Command.SpinMotors command, Responder responder);

  void reboot(Command.Reboot command, Responder responder);

  void light(Command.Light command, Responder responder);

  void acknowledge(Command.Acknowledge command, Responder responder);

  void read(Command.Read command, Responder responder);
}

package tellosimulator.command;

import java.util.Optional;
import tellosimulator.words.Phrase;

/** A target that only counts what it is to carry out; faster than a mock. */
final class CountingTarget implements CommandTarget {

  int carriedOut;
  boolean flying;
  Optional<Phrase> running = Optional.empty();

  @Override
  public Optional<Phrase> running() {
    return running;
  }

  @Override
  public Phrase notFlying() {
    return Phrase.of("the drone does not fly, send `takeoff` first");
  }

  @Override
  public boolean flying() {
    return flying;
  }

  @Override
  public void linkAlive() {}

  @Override
  public void commandArrived() {}

  @Override
  public void enterSdkMode(Command.EnterSdkMode command, Responder responder) {
    count(responder);
  }

  @Override
  public void takeoff(Command.Takeoff command, Responder responder) {
    count(responder);
  }

  @Override
  public void land(Command.Land command, Responder responder) {
    count(responder);
  }

  @Override
  public void stop(Command.Stop command, Responder responder) {
    count(responder);
  }

  @Override
  public void emergency(Command.Emergency command, Responder responder) {
    count(responder);
  }

  @Override
  public void move(Command.Move command, Responder responder) {
    count(responder);
  }

  @Override
  public void turn(Command.Turn command, Responder responder) {
    count(responder);
  }

  @Override
  public void flip(Command.Flip command, Responder responder) {
    count(responder);
  }

  @Override
  public void go(Command.Go command, Responder responder) {
    count(responder);
  }

  @Override
  public void curve(Command.Curve command, Responder responder) {
    count(responder);
  }

  @Override
  public void goToPad(Command.GoToPad command, Responder responder) {
    count(responder);
  }

  @Override
  public void curveOverPad(Command.CurveOverPad command, Responder responder) {
    count(responder);
  }

  @Override
  public void jump(Command.Jump command, Responder responder) {
    count(responder);
  }

  @Override
  public void setSpeed(Command.SetSpeed command, Responder responder) {
    count(responder);
  }

  @Override
  public void rc(Command.Rc command, Responder responder) {
    count(responder);
  }

  @Override
  public void setNetwork(Command.SetNetwork command, Responder responder) {
    count(responder);
  }

  @Override
  public void detectPads(Command.DetectPads command, Responder responder) {
    count(responder);
  }

  @Override
  public void setPadDirection(Command.SetPadDirection command, Responder responder) {
    count(responder);
  }

  @Override
  public void stream(Command.Stream command, Responder responder) {
    count(responder);
  }

  @Override
  public void setVideo(Command.SetVideo command, Responder responder) {
    count(responder);
  }

  @Override
  public void setPorts(Command.SetPorts command, Responder responder) {
    count(responder);
  }

  @Override
  public void spinMotors(Command.SpinMotors command, Responder responder) {
    count(responder);
  }

  @Override
  public void reboot(Command.Reboot command, Responder responder) {
    count(responder);
  }

  @Override
  public void light(Command.Light command, Responder responder) {
    count(responder);
  }

  @Override
  public void acknowledge(Command.Acknowledge command, Responder responder) {
    count(responder);
  }

  @Override
  public void read(Command.Read command, Responder responder) {
    count(responder);
  }

  private void count(Responder responder) {
    carriedOut++;
    if (carriedOut % 2 == 0) {
      responder.reply(Reply.OK);
    }
  }
}

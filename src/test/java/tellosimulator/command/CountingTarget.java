package tellosimulator.command;

import java.util.Optional;
import tellosimulator.words.Phrase;

/** A target that only counts commands. It is faster than a mock. */
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
  public void carryOut(Command command, Responder responder) {
    carriedOut++;
    if (carriedOut % 2 == 0) {
      responder.reply(Reply.OK);
    }
  }
}

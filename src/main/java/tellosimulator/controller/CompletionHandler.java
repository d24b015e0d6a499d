package tellosimulator.controller;

import tellosimulator.command.Reply;
import tellosimulator.command.Responder;
import tellosimulator.words.Phrase;

/** Is told how a maneuver ended, and answers whoever waits for that. */
interface CompletionHandler {

  /** The maneuver ended as planned. */
  void done();

  /** The maneuver ended otherwise. */
  void failed(Reply reply, Phrase reason);

  /** The command as it was sent; empty if nobody waits. */
  String text();

  /** Nobody waits: the drone hovers, or lands by itself. */
  CompletionHandler NOBODY =
      new CompletionHandler() {
        @Override
        public void done() {}

        @Override
        public void failed(Reply reply, Phrase reason) {}

        @Override
        public String text() {
          return "";
        }
      };

  /** The sender of a command waits. */
  static CompletionHandler of(Responder responder) {
    return then(responder, () -> responder.reply(Reply.OK));
  }

  /** The sender of a command waits, but something else comes first. */
  static CompletionHandler then(Responder responder, Runnable next) {
    return new CompletionHandler() {
      @Override
      public void done() {
        next.run();
      }

      @Override
      public void failed(Reply reply, Phrase reason) {
        responder.fail(reply, reason);
      }

      @Override
      public String text() {
        return responder.text();
      }
    };
  }
}

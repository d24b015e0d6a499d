package tellosimulator.controller;

import tellosimulator.command.Reply;
import tellosimulator.command.Responder;
import tellosimulator.words.Phrase;

/** Who waits for the end of the present maneuver, and for which answer. */
interface Task {

  /** The maneuver ended as planned. */
  void done();

  /** The maneuver ended otherwise. */
  void failed(Reply reply, Phrase reason);

  /** The command as it was sent; empty if nobody waits. */
  String text();

  /** Nobody waits: the drone hovers, or lands by itself. */
  Task NOBODY =
      new Task() {
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
  static Task of(Responder responder) {
    return then(responder, () -> responder.reply(Reply.OK));
  }

  /** The sender of a command waits, but something else comes first. */
  static Task then(Responder responder, Runnable next) {
    return new Task() {
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

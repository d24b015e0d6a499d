package tellosimulator.command;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.words.Phrase;

/**
 * One command that waits for its answer: now or later, once, twice ({@code stop}) or never. For the
 * simulation thread.
 */
public final class Responder {

  /** Copies that wait for one answer. The vendor's client sends at most five. */
  private static final int MOST_COPIES = 8;

  private final Peer peer;
  private final String text;
  private final ReplyPort replies;
  private final CommandObserver observer;
  private final List<String> headers = new ArrayList<>(1);
  private final List<Reply> given = new ArrayList<>(1);

  /**
   * @param text the command as sent, without header
   * @param header what each reply begins with; empty for an ordinary command
   */
  Responder(Peer peer, String text, String header, ReplyPort replies, CommandObserver observer) {
    this.peer = peer;
    this.text = text;
    this.replies = replies;
    this.observer = observer;
    headers.add(header);
  }

  public Peer peer() {
    return peer;
  }

  /** The command as it was sent, in a form that can be shown. */
  public String text() {
    return WireText.printable(text);
  }

  public void reply(Reply reply) {
    observer.replied(peer, text, reply);
    send(reply);
  }

  /**
   * Replies, and says why the command is not carried out.
   *
   * @param reason in plain words that follow "refused: "
   */
  public void refuse(Reply reply, Phrase reason) {
    observer.refused(peer, text, reply, reason);
    send(reply);
  }

  /**
   * Replies, and says why the command that was begun came to another end.
   *
   * @param reason in plain words that follow "failed: "
   */
  public void fail(Reply reply, Phrase reason) {
    observer.failed(peer, text, reply, reason);
    send(reply);
  }

  /** Answers a copy of the same command under its own header, now and from now on. */
  void alsoAnswer(String header) {
    given.forEach(reply -> replies.reply(peer, header + reply.text()));
    if (headers.size() < MOST_COPIES) {
      headers.add(header);
    }
  }

  private void send(Reply reply) {
    given.add(reply);
    headers.forEach(header -> replies.reply(peer, header + reply.text()));
  }
}

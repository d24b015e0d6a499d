package tellosimulator.command;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.words.Phrase;

/**
 * Replies to one command: now or later, once, twice ({@code stop}) or never. Confined to the
 * simulation thread.
 */
public final class Responder {

  /**
   * Maximum number of copies of a command, including the original, to which later replies are sent.
   * The vendor's client sends at most five.
   */
  private static final int MOST_COPIES = 8;

  private final Request request;
  private final DronePort port;
  private final CommandObserver observer;
  private final List<String> headers = new ArrayList<>(1);
  private final List<Reply> given = new ArrayList<>(1);

  /**
   * Creates the responder to a command.
   *
   * @param header the prefix of each reply; empty for an ordinary command
   */
  Responder(Request request, String header, DronePort port, CommandObserver observer) {
    this.request = request;
    this.port = port;
    this.observer = observer;
    headers.add(header);
  }

  public Peer peer() {
    return request.peer();
  }

  /** Returns the command as sent, in printable form. */
  public String text() {
    return WireText.printable(request.text());
  }

  public void reply(Reply reply) {
    observer.replied(request, reply);
    send(reply);
  }

  /**
   * Sends the reply to a refused command.
   *
   * @param reason the reason, worded to follow "refused: "
   */
  public void refuse(Reply reply, Phrase reason) {
    observer.refused(request, reply, reason);
    send(reply);
  }

  /**
   * Sends the reply to a command that was begun but could not be completed.
   *
   * @param reason the reason, worded to follow "failed: "
   */
  public void fail(Reply reply, Phrase reason) {
    observer.failed(request, reply, reason);
    send(reply);
  }

  /**
   * Answers a copy of the command: repeats the previous replies under the header of the copy, and
   * sends later replies under that header as well.
   */
  void alsoAnswer(String header) {
    given.forEach(reply -> send(header, reply));
    if (headers.size() < MOST_COPIES) {
      headers.add(header);
    }
  }

  private void send(Reply reply) {
    given.add(reply);
    headers.forEach(header -> send(header, reply));
  }

  private void send(String header, Reply reply) {
    port.send(LinkDatagram.reply(request.peer(), WireText.encode(header + reply.text())));
  }
}

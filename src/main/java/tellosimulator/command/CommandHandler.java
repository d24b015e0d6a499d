package tellosimulator.command;

import java.util.Optional;
import tellosimulator.command.CommandParser.Parsed;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Parses texts into commands, and checks them in the same order as the drone does: the syntax,
 * whether another command is running, the ranges of the parameters, and whether the drone is
 * flying. The {@link CommandTarget} makes all further checks. No text causes an exception. Confined
 * to the simulation thread.
 */
final class CommandHandler {

  private final Profile profile;
  private final Behavior behavior;
  private final CommandParser parser;
  private final Retransmission retransmission = new Retransmission();
  private final CommandTarget target;
  private final Ends ends;
  private final OperatorSession session;
  private final CommandObserver observer;

  /**
   * The session, port and observer of a handler.
   *
   * @param port sends the replies
   * @param observer notified of texts and replies
   */
  record Ends(OperatorSession session, DronePort port, CommandObserver observer) {}

  CommandHandler(Profile profile, Behavior behavior, CommandTarget target, Ends ends) {
    this.profile = profile;
    this.behavior = behavior;
    this.parser = new CommandParser(profile);
    this.target = target;
    this.ends = ends;
    this.session = ends.session();
    this.observer = ends.observer();
  }

  /** Carries out the command in a datagram. Reports a datagram without effect to the observer. */
  void handle(Peer peer, String datagram, SimTime now) {
    boolean tooLong = datagram.length() > WireText.LONGEST;
    String header = profile.hasPads() && !tooLong ? Retransmission.header(datagram) : "";
    String text = tooLong ? datagram : WireText.trimmed(datagram.substring(header.length()));
    if (ignored(peer, text)) {
      return;
    }
    boolean admitted = session.admits(peer);
    if (!admitted && !openToOthers(text)) {
      observer.turnedAway(peer, text, session.refusal(peer));
      return;
    }
    session.heard(peer, now);
    if (admitted) {
      target.linkAlive();
    }
    Optional<Responder> original = retransmission.original(peer, header, text);
    if (original.isPresent()) {
      original.get().alsoAnswer(header);
    } else {
      Request request = new Request(session.nextRequest(), peer, text);
      Responder responder = new Responder(request, header, ends.port(), observer);
      if (!header.isEmpty()) {
        retransmission.remember(header, text, responder);
      }
      carryOut(request, responder, admitted);
    }
  }

  /**
   * Whether any host may send this text: SDK mode is on, and the text is a read command or {@code
   * command}.
   */
  private boolean openToOthers(String text) {
    return session.link().sdkMode()
        && parser.parse(text).filter(parsed -> parsed.syntax().readOnly()).isPresent();
  }

  /** Forgets all earlier commands, so that a later copy of one counts as a new command. */
  void forgetCopies() {
    retransmission.forgetAll();
  }

  private boolean ignored(Peer peer, String text) {
    if (Reply.isEcho(text)) {
      observer.ignored(
          peer, text, Phrase.of("it is a drone's own reply, and an answer would go on for ever"));
      return true;
    }
    if (!session.link().sdkMode() && !text.equals(CommandSyntax.COMMAND.verb())) {
      observer.ignored(peer, text, Phrase.of("the drone waits for `command` first"));
      return true;
    }
    return false;
  }

  private void carryOut(Request request, Responder responder, boolean admitted) {
    observer.received(request);
    String text = request.text();
    Optional<Parsed> parsed = parser.parse(text);
    if (parsed.isEmpty()) {
      responder.refuse(Reply.unknown(echo(text)), parser.explain(text));
      return;
    }
    if (admitted) {
      target.commandArrived();
    }
    Optional<Refusal> refusal = refusal(parsed.get());
    if (refusal.isPresent()) {
      responder.refuse(refusal.get().reply(), refusal.get().reason());
      return;
    }
    target.carryOut(parsed.get().command(), responder);
  }

  private Optional<Refusal> refusal(Parsed parsed) {
    CommandSyntax syntax = parsed.syntax();
    Optional<Phrase> unactivated = target.unactivated();
    if (unactivated.isPresent() && syntax != CommandSyntax.COMMAND) {
      return unactivated.map(reason -> new Refusal(Reply.ERROR, reason));
    }
    Optional<Phrase> running = target.running();
    if (running.isPresent() && !syntax.busyRule().allows(behavior)) {
      return running.map(reason -> new Refusal(Reply.NOT_JOYSTICK, reason));
    }
    Optional<Refusal> complaint = parsed.complaint();
    if (complaint.isPresent()) {
      return complaint;
    }
    return syntax.needsFlight() && !target.flying()
        ? Optional.of(new Refusal(Reply.MOTOR_STOP, target.notFlying()))
        : Optional.empty();
  }

  private String echo(String text) {
    String cut = text.length() > WireText.LONGEST ? text.substring(0, WireText.LONGEST) : text;
    int blank = cut.indexOf(' ');
    return profile.echoesFirstWord(behavior) && blank >= 0 ? cut.substring(0, blank) : cut;
  }
}

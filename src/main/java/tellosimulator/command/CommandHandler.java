package tellosimulator.command;

import java.util.Optional;
import tellosimulator.command.CommandParser.Parsed;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Turns texts into commands, in the order in which the drone checks them: form, busy, range,
 * motors; what is left is up to the {@link CommandTarget}. For the simulation thread. Whatever the
 * text is, it never throws.
 */
public final class CommandHandler {

  /** First byte of the app's binary protocol, which is off in SDK mode. Measured: TelloPy 50. */
  private static final char APP_PROTOCOL = '\u00cc';

  /** How the app asks for a connection. Measured: TelloPy 50. */
  private static final String APP_REQUEST = "conn_req";

  private final Profile profile;
  private final Behavior behavior;
  private final CommandParser parser;
  private final Retransmission retransmission = new Retransmission();
  private final CommandTarget target;
  private final OperatorSession session;
  private final ReplyPort replies;
  private final CommandObserver observer;

  private CommandHandler(Builder parts) {
    this.profile = parts.profile;
    this.behavior = parts.behavior;
    this.parser = new CommandParser(profile);
    this.target = parts.target;
    this.session = parts.session;
    this.replies = parts.replies;
    this.observer = parts.observer;
  }

  public static Builder of(Profile profile, Behavior behavior) {
    return new Builder(profile, behavior);
  }

  /** Takes one datagram. */
  public void handle(Peer peer, String datagram, SimTime now) {
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
      Responder responder = new Responder(peer, text, header, replies, observer);
      if (!header.isEmpty()) {
        retransmission.remember(header, text, responder);
      }
      carryOut(text, responder, admitted);
    }
  }

  /** Whether every host may send it: it asks something, and changes nothing. */
  private boolean openToOthers(String text) {
    return session.link().sdkMode()
        && parser.parse(text).filter(parsed -> parsed.syntax().readOnly()).isPresent();
  }

  /** Lets each command be carried out anew, though a copy of an earlier one. */
  public void forgetCopies() {
    retransmission.forgetAll();
  }

  /** Forgets SDK mode, as without power. */
  public void powerOff() {
    session.close();
    retransmission.forgetAll();
  }

  private boolean ignored(Peer peer, String text) {
    boolean app =
        text.startsWith(APP_REQUEST) || (!text.isEmpty() && text.charAt(0) == APP_PROTOCOL);
    if (app) {
      observer.ignored(peer, text, Phrase.of("it belongs to the app's binary protocol"));
      return true;
    }
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

  private void carryOut(String text, Responder responder, boolean admitted) {
    observer.received(responder.peer(), text);
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
    parsed.get().command().on(target, responder);
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

  /** Gathers the handler's neighbours. */
  public static final class Builder {
    private final Profile profile;
    private final Behavior behavior;
    private CommandTarget target;
    private OperatorSession session;
    private ReplyPort replies;
    private CommandObserver observer;

    private Builder(Profile profile, Behavior behavior) {
      this.profile = profile;
      this.behavior = behavior;
    }

    public Builder target(CommandTarget value) {
      target = value;
      return this;
    }

    public Builder session(OperatorSession value) {
      session = value;
      return this;
    }

    public Builder replies(ReplyPort value) {
      replies = value;
      return this;
    }

    public Builder observer(CommandObserver value) {
      observer = value;
      return this;
    }

    public CommandHandler build() {
      return new CommandHandler(this);
    }
  }
}

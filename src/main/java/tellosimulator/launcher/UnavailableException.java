package tellosimulator.launcher;

/** Thrown if this system does not permit a private network. The message is one sentence. */
public final class UnavailableException extends Exception {

  private static final long serialVersionUID = 1;

  private UnavailableException(String message) {
    super(message);
  }

  /**
   * Creates an exception whose message explains what to do.
   *
   * @param reason the system's message; null if there was none
   */
  static UnavailableException because(String reason) {
    String said = reason == null ? "no reason was given" : reason.strip();
    return new UnavailableException(
        "A private network cannot be made ("
            + said
            + "): it takes Linux with util-linux and iproute2, and a system that lets users make"
            + " namespaces (sudo sysctl kernel.apparmor_restrict_unprivileged_userns=0, or"
            + " kernel.unprivileged_userns_clone=1), or sudo.");
  }
}

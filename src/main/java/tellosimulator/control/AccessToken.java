package tellosimulator.control;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;

/**
 * The secret that each request must carry: on a machine with several users, all of them reach
 * loopback. Immutable.
 */
final class AccessToken {

  /** Decided: 128 bits, which nobody guesses. */
  private static final int BYTES = 16;

  private final String text;

  private AccessToken(String text) {
    this.text = text;
  }

  /** One that nobody can foresee. */
  static AccessToken random() {
    byte[] bytes = new byte[BYTES];
    new SecureRandom().nextBytes(bytes);
    return new AccessToken(HexFormat.of().formatHex(bytes));
  }

  String text() {
    return text;
  }

  /** Whether somebody knows it; takes as long for each wrong one of the same length. */
  boolean is(String said) {
    return MessageDigest.isEqual(
        text.getBytes(StandardCharsets.UTF_8), said.getBytes(StandardCharsets.UTF_8));
  }
}

package tellosimulator.control;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;

/**
 * A secret that requests must contain, because every user of a machine can connect to its loopback
 * interface. Immutable.
 */
public record AccessToken(String text) {

  /** Length of the token [bytes]. Decided: 128 bits cannot be guessed. */
  private static final int BYTES = 16;

  /** Returns a new token. */
  public static AccessToken create() {
    byte[] secret = new byte[BYTES];
    new SecureRandom().nextBytes(secret);
    return new AccessToken(HexFormat.of().formatHex(secret));
  }

  /**
   * Returns whether a text is the token. The comparison takes the same time for all texts of the
   * same length.
   */
  public boolean matches(String said) {
    return MessageDigest.isEqual(
        text.getBytes(StandardCharsets.UTF_8), said.getBytes(StandardCharsets.UTF_8));
  }
}

package tellosimulator.web;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.net.InetAddress;
import java.net.URI;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Optional;
import java.util.Set;

/**
 * Decides who may use the page. A request needs the token, either in its address or in a cookie. A
 * page of another site can make a browser send the cookie, so a cookie counts only if the request
 * names this server as its host and comes from its own page. Immutable.
 */
final class Access {

  /** Length of the token [bytes]. Decided: 128 bits cannot be guessed. */
  private static final int TOKEN_BYTES = 16;

  /** Name of the parameter in the address, and of the header of a request. */
  static final String TOKEN = "token";

  private static final String HEADER = "X-Token";

  private final String token;
  private final String cookie;

  /**
   * Creates access with a new token.
   *
   * @param port the server's port, because cookies of all servers of a host are shared
   */
  Access(int port) {
    byte[] secret = new byte[TOKEN_BYTES];
    new SecureRandom().nextBytes(secret);
    token = HexFormat.of().formatHex(secret);
    cookie = "tello-" + port;
  }

  String token() {
    return token;
  }

  /** Whether a request carries the token in its address or in a header. */
  boolean named(HttpExchange request) {
    return matches(parameter(request.getRequestURI(), TOKEN).orElse(""))
        || matches(first(request.getRequestHeaders(), HEADER));
  }

  /** Whether a request may be answered. */
  boolean allows(HttpExchange request) {
    Headers headers = request.getRequestHeaders();
    boolean foreign = !first(headers, "Origin").isEmpty() && !isOwn(headers);
    return !foreign && (named(request) || (isLocal(headers) && carriesCookie(headers)));
  }

  /** Returns the header that makes a browser send the token from now on. */
  String cookieHeader() {
    return cookie + "=" + token + "; SameSite=Strict; HttpOnly; Path=/";
  }

  private boolean carriesCookie(Headers headers) {
    return headers.getOrDefault("Cookie", java.util.List.of()).stream()
        .flatMap(line -> Arrays.stream(line.split(";")))
        .map(String::strip)
        .anyMatch(
            each -> each.startsWith(cookie + "=") && matches(each.substring(cookie.length() + 1)));
  }

  /** Whether the page that sent a request came from the host that the request names. */
  private static boolean isOwn(Headers headers) {
    String origin = first(headers, "Origin");
    String host = first(headers, "Host");
    return origin.equals("http://" + host) || origin.equals("https://" + host);
  }

  /** Whether a request names an address as its host, which no other site can pretend to be. */
  private static boolean isLocal(Headers headers) {
    String host = first(headers, "Host").replaceFirst(":[0-9]+$", "");
    return LOCAL.contains(host) || host.matches("[0-9.]+|\\[[0-9a-fA-F:.]+]");
  }

  private static final Set<String> LOCAL = Set.of("localhost");

  private boolean matches(String given) {
    return MessageDigest.isEqual(
        given.getBytes(StandardCharsets.UTF_8), token.getBytes(StandardCharsets.UTF_8));
  }

  private static String first(Headers headers, String name) {
    return Optional.ofNullable(headers.getFirst(name)).orElse("");
  }

  /** Returns a parameter in an address. */
  static Optional<String> parameter(URI uri, String name) {
    return Optional.ofNullable(uri.getRawQuery()).stream()
        .flatMap(query -> Arrays.stream(query.split("&")))
        .filter(each -> each.startsWith(name + "="))
        .map(each -> URLDecoder.decode(each.substring(name.length() + 1), StandardCharsets.UTF_8))
        .findFirst();
  }

  /** Returns the link for a browser on this machine, or in its network. */
  String link(InetAddress address, int port) {
    return "http://" + address.getHostAddress() + ":" + port + "/?" + TOKEN + "=" + token;
  }
}

package tellosimulator.web;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.net.InetAddress;
import java.net.URI;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import tellosimulator.control.AccessToken;
import tellosimulator.network.LocalNetworks;

/**
 * Decides who may use the pages. A request needs the token, either in its address or in a cookie.
 * The page of another site can make a browser send the cookie, so a cookie counts only for reading,
 * and only if the request names this server as its host. Immutable.
 */
final class Access {

  /** Name of the parameter in the address. */
  private static final String TOKEN = "token";

  private final AccessToken token = AccessToken.create();
  private final String cookie;

  /**
   * Creates access with a new token.
   *
   * @param port the server's port, because cookies of all servers of a host are shared
   */
  Access(int port) {
    cookie = "tello-" + port;
  }

  AccessToken token() {
    return token;
  }

  /** Whether a request carries the token in its address. */
  boolean named(HttpExchange request) {
    return token.matches(parameter(request.getRequestURI(), TOKEN).orElse(""));
  }

  /** Whether a request may be answered. */
  boolean allows(HttpExchange request) {
    Headers headers = request.getRequestHeaders();
    boolean reads = request.getRequestMethod().equals("GET");
    return isNeighbor(request)
        && isSameOrigin(headers)
        && (named(request) || (reads && isOwnHost(headers) && carriesCookie(headers)));
  }

  /** Whether a request comes from this machine or the local network, as for drones. */
  static boolean isNeighbor(HttpExchange request) {
    InetAddress own = request.getLocalAddress().getAddress();
    InetAddress sender = request.getRemoteAddress().getAddress();
    return own.isLoopbackAddress() || LocalNetworks.look().neighbors(own, sender);
  }

  /** Whether a browser gets the cookie: a proxy would pass it on to other people's servers. */
  boolean offersCookie(HttpExchange request) {
    return named(request) && isOwnHost(request.getRequestHeaders());
  }

  /** Returns the header that makes a browser send the token from now on. */
  String cookieHeader() {
    return cookie + "=" + token.text() + "; SameSite=Strict; HttpOnly; Path=/";
  }

  private boolean carriesCookie(Headers headers) {
    return headers.getOrDefault("Cookie", List.of()).stream()
        .flatMap(line -> Arrays.stream(line.split(";")))
        .map(String::strip)
        .filter(each -> each.startsWith(cookie + "="))
        .anyMatch(each -> token.matches(each.substring(cookie.length() + 1)));
  }

  /**
   * Whether the page that sent a request came from this server. Requests that belong to no page
   * have no origin. Proxies may replace the host, and then say which one was asked for.
   */
  private static boolean isSameOrigin(Headers headers) {
    String origin = first(headers, "Origin").replaceFirst("^https?://", "");
    return origin.isEmpty()
        || origin.equals(first(headers, "Host"))
        || origin.equals(first(headers, "X-Forwarded-Host"));
  }

  /** Whether a request names an address as its host, which no other site can pretend to be. */
  private static boolean isOwnHost(Headers headers) {
    String host = first(headers, "Host").replaceFirst(":[0-9]+$", "");
    return host.equals("localhost") || host.matches("[0-9.]+|\\[[0-9a-fA-F:.]+]");
  }

  static String first(Headers headers, String name) {
    return Optional.ofNullable(headers.getFirst(name)).orElse("");
  }

  /** Returns a parameter in an address. */
  static Optional<String> parameter(URI uri, String name) {
    return Optional.ofNullable(uri.getRawQuery()).stream()
        .flatMap(query -> Arrays.stream(query.split("&")))
        .filter(each -> each.startsWith(name + "="))
        .map(each -> decoded(each.substring(name.length() + 1)))
        .findFirst();
  }

  private static String decoded(String text) {
    try {
      return URLDecoder.decode(text, StandardCharsets.UTF_8);
    } catch (IllegalArgumentException e) {
      return text; // a lone % stands for itself
    }
  }
}

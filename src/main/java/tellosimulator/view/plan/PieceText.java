package tellosimulator.view.plan;

import tellosimulator.math.Frames;
import tellosimulator.view.plan.Piece.Pad;
import tellosimulator.view.plan.Piece.Thing;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Shape;

/** What a piece of the plan is and where, in words; lengths in centimetres. */
final class PieceText {

  private final Language language;
  private final Messages messages;

  PieceText(Language language, Messages messages) {
    this.language = language;
    this.messages = messages;
  }

  /** In the present language. */
  String of(Layout layout, Piece piece) {
    Spot spot = layout.spot(piece);
    if (piece instanceof Pad pad && layout.pad(pad).surface().wall()) {
      return messages.now(
          "piece-hanging",
          pad.id(),
          language.say(layout.pad(pad).surface().phrase()),
          cm(layout.pad(pad).along()),
          cm(layout.pad(pad).height()));
    }
    return messages.now(
        "piece",
        name(layout, piece),
        cm(spot.place().x()),
        cm(spot.place().y()),
        Math.round(Math.toDegrees(spot.heading())));
  }

  private String name(Layout layout, Piece piece) {
    if (piece instanceof Pad pad) {
      return messages.now("piece-pad", pad.id());
    } else if (piece instanceof Thing thing) {
      String name = layout.obstacle(thing).name();
      return messages.now("piece-thing", name, size(layout.obstacle(thing).shape()));
    }
    return messages.now("piece-start", ((Piece.Start) piece).drone());
  }

  private String size(Shape shape) {
    if (shape instanceof Shape.Box box) {
      return messages.now("size-box", cm(box.depth()), cm(box.width()), cm(box.height()));
    } else if (shape instanceof Shape.Cylinder cylinder) {
      return messages.now("size-cylinder", cm(2 * cylinder.radius()), cm(cylinder.height()));
    } else if (shape instanceof Shape.Ring ring) {
      return messages.now("size-ring", cm(2 * ring.radius()), cm(ring.middle()));
    }
    Shape.Frame frame = (Shape.Frame) shape;
    return messages.now("size-frame", cm(frame.width()), cm(frame.opening()), cm(frame.middle()));
  }

  private static long cm(double metres) {
    return Math.round(Frames.centimetres(metres));
  }
}

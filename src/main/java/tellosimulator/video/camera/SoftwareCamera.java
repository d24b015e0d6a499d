package tellosimulator.video.camera;

import java.util.List;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Scene;

/**
 * A software rasteriser: scanline rasterisation with a depth buffer, perspective-correct bilinear
 * mip-mapped textures and Gouraud shading, without display, graphics card or toolkit. It keeps its
 * working memory, so that the next frame allocates nothing. For one thread at a time; cameras of
 * several threads share a {@link RenderCache}.
 */
public final class SoftwareCamera {

  private final RenderCache cache;
  private final ModelViewProjection transform = new ModelViewProjection();
  private final ProjectedVertices vertices = new ProjectedVertices();
  private final Lighting lighting = new Lighting();
  private final ClippedPolygon polygon = new ClippedPolygon();
  private final Gradients gradients = new Gradients();
  private final PolygonRasterizer rasterizer = new PolygonRasterizer();
  private final Span span = new Span();
  private final GouraudShader gouraud = new GouraudShader(gradients, span);
  private final TextureShader.Opaque opaque = new TextureShader.Opaque(gradients, span);
  private final TextureShader.Translucent translucent =
      new TextureShader.Translucent(gradients, span);
  private final int[] triangle = new int[3];

  public SoftwareCamera(RenderCache cache) {
    this.cache = cache;
  }

  /**
   * Renders a scene. Uncovered pixels become black.
   *
   * @param frameBuffer of the size of the camera's image, and of the cache's colour space
   */
  public void draw(Scene scene, PinholeCamera camera, FrameBuffer frameBuffer) {
    CameraIntrinsics intrinsics = camera.intrinsics();
    if (frameBuffer.width() != intrinsics.width() || frameBuffer.height() != intrinsics.height()) {
      throw new IllegalArgumentException(
          "frameBuffer is "
              + frameBuffer.width()
              + " by "
              + frameBuffer.height()
              + ", but the camera has "
              + intrinsics);
    }
    frameBuffer.clear();
    setUp(camera, frameBuffer);
    List<Placed> parts = scene.parts();
    // The room comes first and is behind all else: drawn last, it fails most depth tests.
    for (int i = parts.size() - 1; i >= 0; i--) {
      if (!isTranslucent(parts.get(i).part().finish())) {
        draw(parts.get(i));
      }
    }
    for (int i = 0; i < parts.size(); i++) {
      if (isTranslucent(parts.get(i).part().finish())) {
        draw(parts.get(i));
      }
    }
  }

  private void setUp(PinholeCamera camera, FrameBuffer frameBuffer) {
    transform.setCamera(camera);
    rasterizer.setViewport(frameBuffer.width(), frameBuffer.height());
    span.ensureCapacity(frameBuffer.width());
    gouraud.setTarget(frameBuffer);
    opaque.setTarget(frameBuffer);
    translucent.setTarget(frameBuffer);
  }

  private void draw(Placed placed) {
    RenderMesh mesh = cache.mesh(placed.part());
    transform.setModel(placed);
    if (!transform.intersectsFrustum(mesh.center, mesh.radius * placed.scale())) {
      return;
    }
    vertices.project(mesh, transform);
    Finish finish = placed.part().finish();
    finish.lamps().ifPresent(lamps -> lighting.illuminate(lamps, mesh, placed.pose().attitude()));
    translucent.setOpacity(placed.opacity(), finish == Finish.DECAL);
    drawTriangles(mesh, placed.part());
  }

  private void drawTriangles(RenderMesh mesh, Part part) {
    boolean lit = part.finish().lamps().isPresent();
    TextureShader shader = isTranslucent(part.finish()) ? translucent : opaque;
    MipMap texture = null;
    for (int i = 0; i < mesh.triangles(); i++) {
      if (!setUpTriangle(mesh, i)) {
        continue;
      }
      if (lit) {
        gradients.setLight(lighting.intensities(), mesh.normalIndices, 3 * i);
      } else {
        gradients.setFullLight();
      }
      if (mesh.solid[i] && shader == opaque) {
        gouraud.setColor(cache.color(part, mesh.texCoords[6 * i], mesh.texCoords[6 * i + 1]));
        rasterizer.rasterize(polygon, gouraud);
        continue;
      }
      if (texture == null) { // not before, as it takes long to build a mip map
        texture = cache.texture(part);
        shader.setTexture(texture, lit);
      }
      gradients.setTexture(mesh.texCoords, 6 * i, texture);
      rasterizer.rasterize(polygon, shader);
    }
  }

  /**
   * Clips and culls a triangle and sets up its polygon and gradients; whether it may be visible.
   */
  private boolean setUpTriangle(RenderMesh mesh, int index) {
    int a = mesh.positionIndices[3 * index];
    int b = mesh.positionIndices[3 * index + 1];
    int c = mesh.positionIndices[3 * index + 2];
    int[] outcodes = vertices.outcodes;
    if ((outcodes[a] & outcodes[b] & outcodes[c]) != 0) {
      return false;
    }
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    if (((outcodes[a] | outcodes[b] | outcodes[c]) & ProjectedVertices.NEAR) != 0) {
      polygon.clip(vertices, triangle, transform.near());
    } else if (!polygon.setTriangle(vertices, triangle)) {
      return false;
    }
    return gradients.setTriangle(vertices.homogeneous, triangle);
  }

  private static boolean isTranslucent(Finish finish) {
    return finish == Finish.DECAL || finish == Finish.SHEER;
  }
}

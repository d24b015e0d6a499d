package tellosimulator.video.camera;

import java.util.List;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;

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
    List<Instance> instances = scene.instances();
    // The room comes first and is behind all else: drawn last, it fails most depth tests.
    for (int i = instances.size() - 1; i >= 0; i--) {
      if (!isBlended(instances.get(i))) {
        draw(instances.get(i));
      }
    }
    for (Instance instance : instances) {
      if (isBlended(instance)) {
        draw(instance);
      }
    }
  }

  private static boolean isBlended(Instance instance) {
    return instance.part().material().shading().blended();
  }

  private void setUp(PinholeCamera camera, FrameBuffer frameBuffer) {
    transform.setCamera(camera);
    rasterizer.setViewport(frameBuffer.width(), frameBuffer.height());
    span.ensureCapacity(frameBuffer.width());
    gouraud.setTarget(frameBuffer);
    opaque.setTarget(frameBuffer);
    translucent.setTarget(frameBuffer);
  }

  private void draw(Instance instance) {
    RenderMesh mesh = cache.mesh(instance.part());
    transform.setModel(instance);
    if (!transform.intersectsFrustum(mesh.center, mesh.radius * instance.largestScale())) {
      return;
    }
    vertices.project(mesh, transform);
    Shading shading = instance.part().material().shading();
    shading
        .lights()
        .ifPresent(lights -> lighting.illuminate(lights, mesh, instance.pose().attitude()));
    translucent.setOpacity(instance.opacity(), shading == Shading.DECAL);
    drawTriangles(mesh, instance.part());
  }

  private void drawTriangles(RenderMesh mesh, Part part) {
    boolean lit = part.material().shading().lights().isPresent();
    TextureShader shader = part.material().shading().blended() ? translucent : opaque;
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
}

// Images: four, of the formats of GLES 3.1; read and written are those of r32 only.
#variant COUNT=4|5
#variant BINDING=3|4
#variant FORMAT=r32f|rgba16f KIND=image2D
#variant FORMAT=r32i KIND=iimage2D
#variant FORMAT=r32ui KIND=uimage2D
#variant ACCESS=writeonly FORMAT=rgba16f|rgba8|rgba32f|r16f|rg32f KIND=image2D
#variant ACCESS=readonly FORMAT=rgba32f|rgb10_a2 KIND=image2D
// refused COUNT=5: images.comp:20: 5 images in a compute stage; GLES 3.1 promises 4
// refused COUNT=5: images.comp:20: binding 4 of 'sheets'; GLES 3.1 promises 0 to 3 for images
// refused COUNT=5: images.comp:20: 5 storage blocks, images and outputs together in a compute stage; GLES 3.1 promises 4
// refused BINDING=4: images.comp:22: binding 4 of 'sheet'; GLES 3.1 promises 0 to 3 for images
// refused FORMAT=rgba16f KIND=image2D: images.comp:24: an image of format rgba16f that is neither readonly nor writeonly; GLES 3.1 promises that for r32f, r32i, r32ui only
// refused ACCESS=writeonly FORMAT=r16f KIND=image2D: images.comp:26: an image of format r16f; GLES 3.1 has r32f, r32i,
// refused ACCESS=writeonly FORMAT=rg32f KIND=image2D: images.comp:26: an image of format rg32f; GLES 3.1 has r32f, r32i,
// refused ACCESS=readonly FORMAT=rgb10_a2 KIND=image2D: images.comp:26: an image of format rgb10_a2; GLES 3.1 has r32f, r32i,
layout(local_size_x = 64) in;

#ifdef COUNT
layout(rgba16f, binding = 0) writeonly uniform highp image2D sheets[COUNT];
#elif defined(BINDING)
layout(r32f, binding = BINDING) uniform highp image2D sheet;
#elif !defined(ACCESS)
layout(FORMAT, binding = 0) uniform highp KIND sheet;
#else
layout(FORMAT, binding = 0) ACCESS uniform highp KIND sheet;
#endif

void main()
{
}
